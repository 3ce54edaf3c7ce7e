let of_nodes (program : Ir.program) =
  let uses = Array.make (Array.length program.nodes) 0 in
  let use (i : Ir.instance) = uses.(i.node) <- uses.(i.node) + 1 in
  Array.iter (fun (node : Ir.node) -> List.iter use node.instances) program.nodes;
  uses
