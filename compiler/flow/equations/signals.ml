let iter f (node : Ir.node) =
  List.iter f node.statics;
  List.iter f node.inputs;
  List.iter (fun (e : Ir.equation) -> f e.defines) node.equations;
  List.iter (fun (i : Ir.instance) -> List.iter f i.outputs) node.instances;
  Option.iter (fun (c : Ir.foreign) -> List.iter f c.results) node.foreign;
  Option.iter (fun (m : Ir.machine) -> List.iter f m.outputs) node.machine

let next_id nodes =
  let next = ref 0 in
  let note (s : Ir.signal) = next := Int.max !next (1 + Int.max s.id s.group) in
  Array.iter (iter note) nodes;
  !next
