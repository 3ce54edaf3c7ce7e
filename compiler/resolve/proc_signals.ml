open Syntax.Ir

type t = { name : name; of_do : bool }

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

(* What a [proc] binds. *)
let bound input = function
  | Do { statements; _ } -> List.fold_left add_statement (add_pattern [] input) statements
  | Output { equations; _ } -> List.fold_left add_declaration (add_pattern [] input) equations
  | Command _ -> add_pattern [] input

let of_body = function
  | Plain { desc = Proc { input; body = Do _ as body }; _ } ->
      List.map (fun name -> { name; of_do = true }) (bound input body)
  | Plain _ | Guarded _ -> []

let rec add_expr found (e : expr) =
  match e.desc with
  | Variable _ | Constructor _ | Number _ | String _ -> found
  | Tuple es | Array es -> List.fold_left add_expr found es
  | Apply (a, b) | Binary { left = a; right = b; _ } -> add_expr (add_expr found a) b
  | Negate a | Left_section { left = a; _ } | Right_section { right = a; _ } | Power { base = a; _ }
  | Lambda { body = a; _ } | Field { record = a; _ } | Annotated { expr = a; _ } | Parenthesized a ->
      add_expr found a
  | If { condition; then_; else_ } -> List.fold_left add_expr found [ condition; then_; else_ ]
  | Case { scrutinee; branches } -> List.fold_left add_branch (add_expr found scrutinee) branches
  | Let { bindings; body } -> add_expr (add_bindings found bindings) body
  | Sequence { statements; result } ->
      add_expr (List.fold_left add_task_statement found statements) result
  | Record { fields; _ } -> add_fields found fields
  | Update { record; fields } -> add_fields (add_expr found record) fields
  | Proc { input; body } ->
      let own = List.map (fun name -> { name; of_do = false }) (bound input body) in
      let found = List.rev_append own found in
      (match body with
      | Output { output; equations } -> add_bindings (add_expr found output) equations
      | Command command -> add_command found command
      | Do { statements; result } ->
          add_command (List.fold_left add_proc_statement found statements) result)

and add_fields found fields = List.fold_left (fun found (_, e) -> add_expr found e) found fields

and add_branch found (b : branch) =
  let found =
    match b.body with
    | Always e -> add_expr found e
    | If_guards guards -> add_guards found guards
  in
  add_bindings found b.where

and add_guards found guards =
  List.fold_left (fun found (guard, e) -> add_expr (add_expr found guard) e) found guards

and add_task_statement found = function
  | Task { task; _ } -> add_expr found task
  | Let_values bindings -> add_bindings found bindings

and add_proc_statement found = function
  | Bind { command; _ } -> add_command found command
  | Bind_expr { expr; _ } -> add_expr found expr
  | Let_equations bindings -> add_bindings found bindings

and add_command found { signal_function; argument; _ } =
  add_expr (add_expr found signal_function) argument

and add_bindings found bindings =
  List.fold_left
    (fun found (d : declaration) ->
      match d.desc with Binding { right; _ } -> add_right found right | _ -> found)
    found bindings

and add_right found (r : right) =
  let found =
    match r.body with Plain e -> add_expr found e | Guarded guards -> add_guards found guards
  in
  add_bindings found r.where

let of_right r = List.rev (add_right [] r)
