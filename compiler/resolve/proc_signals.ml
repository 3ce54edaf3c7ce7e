open Syntax.Ir

let rec add_pattern names (p : pattern) =
  match p.desc with
  | Any | Literal _ -> names
  | Bound name -> name :: names
  | As (name, p) -> add_pattern (name :: names) p
  | Tuple_of ps | Constructed (_, ps) -> List.fold_left add_pattern names ps
  | Record_of (_, fields) -> List.fold_left (fun names (_, p) -> add_pattern names p) names fields

let add_declaration names (d : declaration) =
  match d.desc with
  | Binding { left = Name name | Function_name { name; _ }; _ } -> name :: names
  | Binding { left = Pattern p; _ } -> add_pattern names p
  | Signature _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Primitive _ | Foreign _ | Class _
  | Instance _ ->
      names

let add_statement names = function
  | Bind { pattern; _ } | Bind_expr { pattern; _ } -> add_pattern names pattern
  | Let_equations declarations -> List.fold_left add_declaration names declarations

let of_body = function
  | Plain { desc = Proc { input; body = Do { statements; _ } }; _ } ->
      List.fold_left add_statement (add_pattern [] input) statements
  | Plain { desc = Proc { input; body = Output _ | Command _ }; _ } -> add_pattern [] input
  | Plain _ | Guarded _ -> []
