open Basis

let of_nodes (program : Ir.program) =
  let uses = Array.make (Array.length program.nodes) 0 in
  let use (i : Ir.instance) = uses.(i.node) <- uses.(i.node) + 1 in
  Array.iter (fun (node : Ir.node) -> List.iter use node.instances) program.nodes;
  uses

let of_signals (node : Ir.node) =
  let uses = Int_table.create 64 in
  let count (s : Ir.signal) = Option.value (Int_table.find_opt uses s.id) ~default:0 in
  let read (atom : Ir.atom) =
    match atom with
    | Signal s -> Int_table.replace uses s.id (1 + count s)
    | Bool _ | Int _ | Float _ -> ()
  in
  let read_all = List.iter read in
  List.iter (fun (e : Ir.equation) -> read_all (Operands.all e.rhs)) node.equations;
  List.iter
    (fun (i : Ir.instance) ->
      read_all i.statics;
      read_all i.inputs;
      List.iter (fun (trial : Ir.trial) -> List.iter (Option.iter read) trial.given) i.trials)
    node.instances;
  Option.iter
    (fun (machine : Ir.machine) ->
      read_all (Transitions.atoms machine.start);
      read_all (Transitions.read_in_step machine))
    node.machine;
  read_all (Transitions.atoms node.transitions);
  List.iter (fun (_, atom) -> read atom) node.outputs;
  count
