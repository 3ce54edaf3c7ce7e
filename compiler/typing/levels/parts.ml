open Ir

let rec exists leaf (e : expr) =
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> leaf e
  | _ -> List.exists (exists leaf) (Walk.children e)

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
