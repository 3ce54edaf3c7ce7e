(* Maximum number of candidates in a mode, to keep the pass linear. In practice, no mode has that
   many. *)
let most_candidates = 16

let node (node : Ir.node) =
  if node.transitions = [] then node
  else
    let while_running = Truth.while_running node in
    let stays s b next = Truth.value (while_running [ (s, b) ]) next = Some b in
    let candidates = ref 0 in
    let constant (e : Ir.equation) : Ir.equation =
      match e.rhs with
      | Delay { init = Bool b; next } when !candidates < most_candidates ->
          incr candidates;
          if stays e.defines b next then { e with rhs = Copy (Bool b) } else e
      | _ -> e
    in
    let equations = Basis.Long_list.map_sharing constant node.equations in
    if equations == node.equations then node else { node with equations }

let program = Simplify.after node
