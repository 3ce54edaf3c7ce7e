open Syntax.Ir

type t = { name : name; of_do : bool }

let rec add_pattern names (p : pattern) =
  match p.desc with
  | Any | Literal _ -> names
  | Bound name -> name :: names
  | As (name, p) -> add_pattern (name :: names) p
  | Tuple_of ps | Array_of ps | Constructed (_, ps) -> List.fold_left add_pattern names ps
  | Record_of (_, fields) -> List.fold_left (fun names (_, p) -> add_pattern names p) names fields

let add_declaration names (d : declaration) =
  match d.desc with
  | Binding { left = Name name | Function_name { name; _ }; _ } -> name :: names
  | Binding { left = Pattern p; _ } -> add_pattern names p
  | Signature _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Primitive _ | Foreign _
  | Parameter _ | Class _ | Instance _ | Claim _ | Check _ ->
      names

let add_statement names = function
  | Bind { pattern; _ } | Bind_expr { pattern; _ } -> add_pattern names pattern
  | Let_equations declarations -> List.fold_left add_declaration names declarations

(* The names that a [proc] binds. *)
let bound input = function
  | Do { statements; _ } -> List.fold_left add_statement (add_pattern [] input) statements
  | Output { equations; _ } -> List.fold_left add_declaration (add_pattern [] input) equations
  | Command _ -> add_pattern [] input

let of_body = function
  | Plain { desc = Proc { input; body = Do _ as body }; _ } ->
      List.map (fun name -> { name; of_do = true }) (bound input body)
  | Plain _ | Guarded _ -> []

let of_right r =
  let rec add found (node : Syntax.Node.t) =
    let own =
      match node with
      | Expression { desc = Proc { input; body }; _ } ->
          List.rev_map (fun name -> { name; of_do = false }) (bound input body)
      | _ -> []
    in
    List.fold_left add (own @ found) (Syntax.Node.children node)
  in
  List.fold_left add [] (Syntax.Node.of_right r)
  |> List.sort (fun a b -> Basis.Span.compare a.name.span b.name.span)

let of_surroundings rights =
  let rec from = function
    | [] -> []
    | [ outermost ] -> of_body outermost.body @ of_right outermost
    | (r : right) :: outer -> of_body r.body @ from outer
  in
  from rights

let rights (program : program) =
  let declaration (d : declaration) = match d.desc with Binding b -> Some b.right | _ -> None in
  List.filter_map declaration program.declarations

let of_module program = List.concat_map of_right (rights program)

let in_capitals (program : program) =
  let declared (d : declaration) =
    match d.desc with
    | Binding { left = Pattern { desc = Constructed ({ qualifier = None; name; _ }, _); _ }; _ } ->
        Some name.text
    | _ -> None
  in
  List.filter_map declared program.declarations

let without_definition (program : program) =
  let defined = Hashtbl.create 16 in
  List.iter
    (fun (d : declaration) ->
      match d.desc with
      | Binding { left = Name name | Function_name { name; _ }; _ } ->
          Hashtbl.replace defined name.text ()
      | _ -> ())
    program.declarations;
  List.concat_map
    (fun (d : declaration) ->
      match d.desc with
      | Signature { names; _ } ->
          List.filter_map
            (fun (name : name) -> if Hashtbl.mem defined name.text then None else Some name.text)
            names
      | Binding { left = Pattern { desc = Constructed (_, [ { desc = Bound name; _ } ]); _ }; _ } ->
          [ name.text ]
      | _ -> [])
    program.declarations

let is_c_type = function
  | "int" | "float" | "double" | "bool" | "char" | "long" | "unsigned" | "auto" | "var" | "let"
  | "uint8_t" | "uint16_t" | "int16_t" | "int32_t" | "byte" | "boolean" | "const" ->
      true
  | _ -> false

type c_declaration = { head : name; type_ : string; declared : name; value : string option }

(* The digits of the right-hand side, if it is a literal number without a unit. *)
let set_to (right : right) =
  match right.body with
  | Plain { desc = Number { digits; unit_ = None; _ }; _ } -> Some digits
  | _ -> None

let c_declarations program =
  let rec add found (node : Syntax.Node.t) =
    let own =
      match node with
      | Declaration { desc = Binding { left = Function_name { name; parameters }; right; _ }; _ }
        when is_c_type name.text -> (
          let word (p : pattern) = match p.desc with Bound word -> Some word.text | _ -> None in
          let words = name.text :: List.filter_map word parameters in
          let is_type word = is_c_type word && not (List.mem word Beginnings.needless) in
          let type_ = Option.value (List.find_opt is_type words) ~default:name.text in
          match List.rev parameters with
          | {
              desc = Bound declared | Constructed ({ qualifier = None; name = declared; _ }, []);
              _;
            }
            :: _ ->
              [ { head = name; type_; declared; value = set_to right } ]
          | _ -> [])
      | _ -> []
    in
    List.fold_left add (own @ found) (Syntax.Node.children node)
  in
  List.fold_left (fun found d -> add found (Syntax.Node.Declaration d)) [] program.declarations
