(* More than a mode has, and it keeps this linear. *)
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
    let equations = List.map constant node.equations in
    if List.for_all2 ( == ) equations node.equations then node else { node with equations }

let program (program : Ir.program) =
  let pass ~fresh before =
    let after = node before in
    if after == before then before else Simplify.node program.real ~fresh after
  in
  Each_node.program pass program
