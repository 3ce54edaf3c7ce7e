open Basis
open Typing
open Type_text

type t = {
  around : Surroundings.t;
  mutable namesakes : string list;  (** names shared by data types from different modules *)
  names : (int, string) Hashtbl.t;  (** names chosen for unsolved variables, by id *)
  taken : (string, unit) Hashtbl.t;
}

let of_surroundings around =
  { around; namesakes = []; names = Hashtbl.create 8; taken = Hashtbl.create 8 }

(* Messages elide the parts of a type that are nested more deeply than this. *)
let deepest = 12
let longest_quote = 60

let quote words (at : Span.t) =
  match Source.quote words.around.sources at with
  | Some text when String.length text <= longest_quote -> Some text
  | Some _ | None -> None

let argument words (e : Resolve.Ir.expr) = Option.map Source.grouped (quote words e.span)
let argument_or otherwise words e = Option.value (argument words e) ~default:otherwise
let sources words = words.around.sources
let environment words = words.around.environment
let named words name = words.around.named name
let needs_class words t = words.around.needs_class t

let imports words ~file module_ =
  let is_import line =
    match String.split_on_char ' ' line |> List.filter (( <> ) "") with
    | "import" :: name :: _ -> String.equal name module_
    | _ -> false
  in
  match Source.text words.around.sources file with
  | Some text -> List.exists is_import (String.split_on_char '\n' text)
  | None -> false

let hidden words (x : Resolve.Ir.Local.t) =
  let in_scope (g : Resolve.Ir.Global.t) =
    String.equal g.module_ "Prelude"
    || imports words ~file:x.span.file g.module_
    ||
    match words.around.binding g with
    | Some b -> String.equal b.span.file x.span.file
    | None -> false
  in
  let is_function t =
    match Type.expand t with Type.Function _ | Signal_function _ -> true | _ -> false
  in
  List.find_opt (fun (g, t) -> is_function t && in_scope g) (words.around.named x.name)

let definition words x = words.around.definition x
let local words x = words.around.local x
let unit_written words u = words.around.unit_ u
let binding words g = words.around.binding g
let local_function words x = words.around.local_function x
let parameter words x = words.around.parameter x
let unnamed_input words = words.around.unnamed_input
let declared_type words g = words.around.declared g
let inputs words = words.around.inputs
let enclosing words = words.around.enclosing
let fields words t = words.around.fields t
let field_of words t ~of_ = words.around.field_of t ~of_
let field_type words t name = words.around.field_type t name
let choices words t = words.around.choices t
let values words t ~file = words.around.values t ~file
let makers words t ~of_ = words.around.makers t ~of_
let owner words v = words.around.owner v
let is_input words name = List.mem_assoc name words.around.inputs

let signal words input =
  let same_kind t =
    match (Head.of_type input, Head.of_type t) with Some (a, _), Some (b, _) -> a = b | _ -> true
  in
  Option.map fst (List.find_opt (fun (_, t) -> same_kind t) words.around.inputs)

(* {2 Types with the same name} *)

let rec data_types found t =
  match Type.repr t with
  | Data { tycon; arguments; _ } | Alias { alias = tycon; arguments; _ } ->
      List.fold_left data_types (tycon :: found) arguments
  | Tuple ts -> List.fold_left data_types found ts
  | Function (a, b) | Signal_function (a, b) -> data_types (data_types found a) b
  | Flexible _ | Rigid _ | Number _ | Bool | String | Size _ | Erroneous -> found

let tell_apart words types =
  let all = List.fold_left data_types [] types in
  let has_namesake (g : Ir.Global.t) =
    List.exists (fun (other : Ir.Global.t) -> other.name = g.name && other.module_ <> g.module_) all
  in
  words.namesakes <-
    List.filter has_namesake all
    |> List.map (fun (g : Ir.Global.t) -> g.name)
    |> List.sort_uniq String.compare

let namesakes words = words.namesakes

let data_name words (g : Ir.Global.t) =
  if List.mem g.name words.namesakes then g.module_ ^ "." ^ g.name else g.name

let of_rigid words (variable : Ir.variable) =
  Hashtbl.replace words.taken variable.name ();
  variable.name

let of_flexible words id candidates =
  match Hashtbl.find_opt words.names id with
  | Some name -> name
  | None ->
      let rec choose k =
        let name = Variable_name.nth candidates k in
        if Hashtbl.mem words.taken name then choose (k + 1) else name
      in
      let name = choose 0 in
      Hashtbl.replace words.names id name;
      Hashtbl.replace words.taken name ();
      name

let measure words u =
  let u = Units.resolve u in
  match Environment.named_unit words.around.environment u with
  | Some name -> name
  | None ->
      let rigid =
        List.map
          (fun ((r : Units.rigid), p) -> (of_rigid words r.variable, p))
          (Units.rigid_powers u)
      in
      let flexible =
        List.map
          (fun (id, p) -> (of_flexible words id Variable_name.Unit, p))
          (Units.flexible_powers u)
      in
      product (rigid @ flexible @ base_names (Units.base_powers u))

let representation_name words r =
  match Type.representation r with
  | Int -> `Named "Int"
  | Float -> `Named "Float"
  | Flexible_representation { id; _ } ->
      `Variable (of_flexible words id Variable_name.Representation)
  | Rigid_representation { variable; _ } -> `Variable (of_rigid words variable)

let representation words r =
  match representation_name words r with `Named name | `Variable name -> name

let rec tree_of words depth t =
  let continue_ = tree_of words (depth + 1) in
  if depth > deepest then Word "…"
  else
    match Type.repr t with
    | Flexible { id; kind = Of_types; _ } -> Word (of_flexible words id Variable_name.Type)
    | Flexible { id; kind = Of_sizes; _ } -> Word (of_flexible words id Variable_name.Size)
    | Rigid { variable; _ } -> Word (of_rigid words variable)
    | Number (r, u) ->
        let r = representation_name words r in
        Word (number r (measure words u))
    | Bool -> Word "Bool"
    | String -> Word "String"
    | Size n -> Word (string_of_int n)
    | Tuple elements -> Group (List.map continue_ elements)
    | Function (a, b) ->
        let a = continue_ a in
        Arrow (a, continue_ b)
    | Signal_function (a, b) ->
        let a = continue_ a in
        Applied ("SF", [ a; continue_ b ])
    | Alias { alias; units = [ u ]; arguments = []; expansion = Number (_, v) } when Units.equal u v
      ->
        Word (number (`Named (data_name words alias)) (measure words u))
    | Data { tycon; units; arguments } | Alias { alias = tycon; units; arguments; _ } ->
        applied
          (bracketed (data_name words tycon) (List.map (measure words) units))
          (List.map continue_ arguments)
    | Erroneous -> Word "_"

(* Reserves the names that signatures use, before any name is generated. *)
let rec reserve words depth t =
  if depth <= deepest then
    let continue_ = reserve words (depth + 1) in
    let units =
      List.iter (fun u ->
          List.iter
            (fun ((r : Units.rigid), _) -> ignore (of_rigid words r.variable))
            (Units.rigid_powers (Units.resolve u)))
    in
    match Type.repr t with
    | Rigid { variable; _ } -> ignore (of_rigid words variable)
    | Number (r, u) -> (
        units [ u ];
        match Type.representation r with
        | Rigid_representation { variable; _ } -> ignore (of_rigid words variable)
        | Flexible_representation _ | Int | Float -> ())
    | Tuple elements -> List.iter continue_ elements
    | Function (a, b) | Signal_function (a, b) ->
        continue_ a;
        continue_ b
    | Data { units = us; arguments; _ } | Alias { units = us; arguments; _ } ->
        units us;
        List.iter continue_ arguments
    | Flexible _ | Bool | String | Size _ | Erroneous -> ()

let type_ words t =
  reserve words 0 t;
  write (tree_of words 0 t)

let declared t g =
  Option.map
    (type_ (of_surroundings (Annotation.nowhere t.around.environment)))
    (t.around.declared g)

let rec parameters t =
  match Type.expand t with
  | Type.Function (parameter, result) -> parameter :: parameters result
  | Signal_function (input, _) -> [ input ]
  | _ -> []

let declared_parameter t g position =
  let parameter ty = List.nth_opt (parameters ty) (position - 1) in
  Option.bind (t.around.declared g) parameter
  |> Option.map (type_ (of_surroundings (Annotation.nowhere t.around.environment)))

let constraint_ words c t =
  reserve words 0 t;
  write (Applied (Show.class_ c, [ tree_of words 0 t ]))

let quoted words t =
  let text = "`" ^ type_ words t ^ "`" in
  match (Type.repr t, Type.expand t) with
  | Alias { units = []; _ }, Number (_, u) -> Printf.sprintf "%s (%s)" text (measure words u)
  | _ -> text

let is_any_number t =
  match Type.expand t with
  | Number (r, u) -> (
      let u = Units.resolve u in
      match (Type.representation r, Units.flexible_powers u) with
      | Flexible_representation _, [] -> Units.equal u Units.one
      | Flexible_representation _, [ _ ] -> Units.base_powers u = [] && Units.rigid_powers u = []
      | _ -> false)
  | _ -> false

let has_any_representation t =
  match Type.expand t with
  | _ when is_any_number t -> true
  | Number (r, u) -> (
      match (Type.representation r, Units.flexible_powers (Units.resolve u)) with
      | Flexible_representation _, [] -> true
      | _ -> false)
  | _ -> false

(* The text of a type, for use in a sentence. A number with an undetermined representation needs no
   generated name for the representation. *)
let described words t =
  match Type.expand t with
  | _ when is_any_number t -> "a number"
  | Number (_, u) when has_any_representation t ->
      Printf.sprintf "a number in `%s`" (measure words (Units.resolve u))
  | _ -> quoted words t
