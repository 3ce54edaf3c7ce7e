type pass = fresh:(unit -> int) -> Ir.node -> Ir.node

let program (pass : pass) (program : Ir.program) =
  let next = ref program.next_id in
  let fresh () =
    let id = !next in
    incr next;
    id
  in
  let nodes = Array.map (pass ~fresh) program.nodes in
  if Array.for_all2 ( == ) nodes program.nodes then program
  else { program with nodes; next_id = !next }
