open Basis
open Ir

let rec globals found (e : expr) =
  match e.desc with
  | Global (g, _) -> g :: found
  | Local _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ -> found
  | Lambda (_, e) | Component (e, _) | Index (e, _) | Is_constructor (e, _) | Payload { value = e; _ } ->
      globals found e
  | Apply (a, b) -> globals (globals found a) b
  | Let { value; body; binder = _ } -> globals (globals found value) body
  | Tuple es | Array es | Construct { arguments = es; _ } -> List.fold_left globals found es
  | If (a, b, c) -> globals (globals (globals found a) b) c
  | Proc p ->
      let right found (eq : equation) =
        match eq.rhs with
        | Pure e -> globals found e
        | Run { signal_function; input } -> globals (globals found signal_function) input
      in
      globals (List.fold_left right found p.equations) p.output

let definitions list =
  let all = Array.of_list list in
  let index = Resolve.Global_table.create (Array.length all) in
  Array.iteri (fun i (d : definition) -> Resolve.Global_table.replace index d.name i) all;
  let uses (d : definition) =
    List.filter_map (fun g -> Resolve.Global_table.find_opt index g) (globals [] d.body)
  in
  let components = Graph.components (Array.map uses all) in
  let add reversed component =
    List.fold_left
      (fun reversed i -> all.(i) :: reversed)
      reversed
      (List.sort Int.compare component)
  in
  List.rev (List.fold_left add [] components)
