let node (node : Ir.node) =
  let definitions = Truth.definitions node in
  let definition (s : Ir.signal) = Basis.Int_table.find_opt definitions s.id in
  let is_mark : Ir.atom -> bool = function
    | Signal s -> definition s = Some (Delay { init = Bool false; next = Bool true })
    | Bool _ | Int _ | Float _ -> false
  in
  let at_first = lazy (Truth.at_first_instant node) in
  let is_redundant mark x = is_mark mark && Truth.value (Lazy.force at_first) x = Some false in
  let equation (e : Ir.equation) =
    match e.rhs with
    | Op (And, [ mark; x ]) when is_redundant mark x -> { e with rhs = Copy x }
    | Op (And, [ x; mark ]) when is_redundant mark x -> { e with rhs = Copy x }
    | _ -> e
  in
  let equations = Basis.Long_list.map_sharing equation node.equations in
  if equations == node.equations then node else { node with equations }

let program = Simplify.after node
