module Global_table = Resolve.Global_table

type term = Number of float | Parameter of int | Sum of int
type relation = At_least | Above | At_most | Differs
type requirement = { left : term; relation : relation; right : term }
type for_angles = { name : string; module_ : string; same_arguments : bool }
type facts = { requires : requirement list; for_angles : for_angles option; wraps : bool }
type t = facts Global_table.t

(* {1 Sentences} *)

(* The text after the first occurrence of a marker. *)
let after marker text =
  let n = String.length marker and all = String.length text in
  let rec from k =
    if k + n > all then None
    else if String.sub text k n = marker then Some (String.sub text (k + n) (all - k - n))
    else from (k + 1)
  in
  from 0

let words text = List.filter (( <> ) "") (String.split_on_char ' ' text)

(* The strings in backticks in the first sentence of the text. *)
let quoted text =
  let rec go = function
    | before :: inside :: rest when not (String.starts_with ~prefix:"." before) -> inside :: go rest
    | _ -> []
  in
  go (String.split_on_char '`' text)

let position names name =
  List.find_map Fun.id (List.mapi (fun k found -> if found = name then Some k else None) names)

let term names text =
  match (float_of_string_opt text, position names text) with
  | Some x, _ -> Some (Number x)
  | None, Some k -> Some (Parameter k)
  | None, None -> None

let relation = function
  | ">=" -> Some At_least
  | ">" -> Some Above
  | "<=" -> Some At_most
  | "/=" -> Some Differs
  | _ -> None

let requirement names text =
  let compared left operator right =
    match (left, relation operator, term names right) with
    | Some left, Some relation, Some right -> Some { left; relation; right }
    | _ -> None
  in
  match words text with
  | [ "sum"; array; operator; right ] ->
      compared (Option.map (fun k -> Sum k) (position names array)) operator right
  | [ left; operator; right ] -> compared (term names left) operator right
  | _ -> None

(* The name after a marker, and the name of the module in parentheses after it. *)
let other_function text ~same_arguments marker =
  match Option.map (String.split_on_char '`') (after marker text) with
  | Some (_ :: name :: rest :: _) ->
      let module_ =
        match Option.map (String.split_on_char ')') (after "(module " rest) with
        | Some (module_ :: _) when String.starts_with ~prefix:" (module " rest -> module_
        | _ -> "Angles"
      in
      Some { name; module_; same_arguments }
  | _ -> None

let facts names doc =
  let text = String.concat " " (List.map String.trim (String.split_on_char '\n' doc)) in
  let requires =
    match after "Requires:" text with
    | Some rest -> List.filter_map (requirement names) (quoted rest)
    | None -> []
  in
  let for_angles =
    match other_function text ~same_arguments:true "For angles that wrap, use" with
    | Some other -> Some other
    | None -> other_function text ~same_arguments:false "For angles that wrap, see"
  in
  { requires; for_angles; wraps = after "wraps at pi" text <> None }

(* {1 Names of parameters} *)

(* The names of the parameters in the call at the beginning of a comment, such as [`lowPass
   tau`]. *)
let called name doc =
  match quoted doc with
  | first :: _ when String.starts_with ~prefix:"`" (String.trim doc) -> (
      match words first with
      | head :: (_ :: _ as parameters) when head = name -> Some parameters
      | _ -> None)
  | _ -> None

let bound (p : Resolve.Ir.pattern) = match p.desc with Bound x -> x.name | _ -> ""

let of_program (program : Resolve.Ir.program) =
  let table = Global_table.create 64 in
  let add (g : Resolve.Ir.Global.t) names doc =
    match doc with
    | None -> ()
    | Some doc ->
        let names = Option.value (called g.name doc) ~default:names in
        Global_table.replace table g (facts names doc)
  in
  let binding (b : Resolve.Ir.binding) =
    match b.name with
    | Top (g, _) -> add g (List.map bound b.parameters) b.doc
    | Inner _ | Destructure _ -> ()
  in
  let data (d : Resolve.Ir.type_declaration) =
    match d.definition with
    | Data [ c ] ->
        let field (f : Resolve.Ir.field) = f.field_name in
        add c.constructor (List.map field c.fields) d.doc
    | _ -> ()
  in
  List.iter (fun (p : Resolve.Ir.primitive) -> add p.name [] p.doc) program.primitives;
  List.iter (fun (g : Resolve.Ir.binding_group) -> List.iter binding g.bindings) program.groups;
  List.iter data program.types;
  table

let requirements t g =
  match Global_table.find_opt t g with Some facts -> facts.requires | None -> []

let for_angles t g = Option.bind (Global_table.find_opt t g) (fun facts -> facts.for_angles)
let wraps t g = match Global_table.find_opt t g with Some facts -> facts.wraps | None -> false
