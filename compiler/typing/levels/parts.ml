open Ir

let exists leaf (e : expr) =
  let rec expr (e : expr) =
    match e.desc with
    | Local _ | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> leaf e
    | Tuple es | Array es -> List.exists expr es
    | Apply (a, b) | Run (a, b) -> expr a || expr b
    | Index (a, _) | Negate a | Power (a, _) | Field (a, _, _) | Lambda (_, a) -> expr a
    | If (a, b, c) -> expr a || expr b || expr c
    | Case (a, branches) -> expr a || List.exists (fun (b : branch) -> expr b.value) branches
    | Let (bindings, body) | Proc { equations = bindings; output = body; _ } ->
        List.exists (fun (b : binding) -> expr b.value) bindings || expr body
    | Guards (guarded, last) ->
        List.exists (fun (g, value) -> expr g || expr value) guarded
        || Option.fold ~none:false ~some:expr last
    | Record (_, fields) -> List.exists (fun (_, value) -> expr value) fields
    | Update (record, _, fields) -> expr record || List.exists (fun (_, value) -> expr value) fields
  in
  expr e

let rec is_static = function
  | Function _ | Signal_function _ -> true
  | Tuple parts -> List.exists is_static parts
  | Data { tycon; arguments; _ } -> tycon = Environment.task || List.exists is_static arguments
  | Variable _ | Number _ | Bool | String | Size _ -> false

let variables (p : pattern) =
  let rec collect found (p : pattern) =
    match p.desc with
    | Any | Literal _ -> found
    | Bound x -> x :: found
    | As (x, p) -> collect (x :: found) p
    | Tuple_of ps | Array_of ps | Constructed (_, ps) -> List.fold_left collect found ps
  in
  collect [] p
