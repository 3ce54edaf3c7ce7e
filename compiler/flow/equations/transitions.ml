let atoms transitions =
  List.concat_map (fun (t : Ir.transition) -> t.occurs :: t.arguments) transitions

let map f transitions =
  List.map
    (fun (t : Ir.transition) -> { t with occurs = f t.occurs; arguments = List.map f t.arguments })
    transitions

let read_in_step (machine : Ir.machine) =
  List.rev_append (List.rev machine.inputs) (Option.to_list machine.active @ atoms machine.controls)

let map_machine atom signal (machine : Ir.machine) =
  {
    machine with
    start = map atom machine.start;
    active = Option.map atom machine.active;
    controls = map atom machine.controls;
    inputs = List.map atom machine.inputs;
    outputs = List.map signal machine.outputs;
  }

let into (program : Ir.program) (machine : Ir.machine) visit =
  List.iter visit machine.start;
  List.iter visit machine.controls;
  List.iter (fun mode -> List.iter visit program.nodes.(mode).transitions) machine.modes

let owners (program : Ir.program) =
  let owners = Array.make (Array.length program.nodes) None in
  Array.iteri
    (fun index (node : Ir.node) ->
      let own mode = owners.(mode) <- Some index in
      Option.iter (fun (machine : Ir.machine) -> List.iter own machine.modes) node.machine)
    program.nodes;
  owners
