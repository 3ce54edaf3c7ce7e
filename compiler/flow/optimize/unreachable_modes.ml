(* Drops transitions that never occur, and those after a transition that always occurs. *)
let rec possible (transitions : Ir.transition list) =
  match transitions with
  | [] -> []
  | { occurs = Bool false; _ } :: others -> possible others
  | ({ occurs = Bool true; _ } as last) :: _ -> [ last ]
  | first :: others -> first :: possible others

let reached (nodes : Ir.node array) (machine : Ir.machine) =
  let modes = Array.of_list machine.modes in
  let reached = Array.make (Array.length modes) false in
  let rec visit (t : Ir.transition) =
    if not reached.(t.target) then (
      reached.(t.target) <- true;
      List.iter visit nodes.(modes.(t.target)).transitions)
  in
  List.iter visit machine.start;
  List.iter visit machine.controls;
  reached

let prune (nodes : Ir.node array) (machine : Ir.machine) =
  let machine =
    { machine with start = possible machine.start; controls = possible machine.controls }
  in
  let cut mode =
    nodes.(mode) <- { (nodes.(mode)) with transitions = possible nodes.(mode).transitions }
  in
  List.iter cut machine.modes;
  let reached = reached nodes machine in
  let numbers = Array.make (Array.length reached) (-1) in
  let count = ref 0 in
  Array.iteri
    (fun k is_reached ->
      if is_reached then (
        numbers.(k) <- !count;
        incr count))
    reached;
  let renumber = List.map (fun (t : Ir.transition) -> { t with target = numbers.(t.target) }) in
  List.iteri
    (fun k mode ->
      let transitions = if reached.(k) then renumber nodes.(mode).transitions else [] in
      nodes.(mode) <- { (nodes.(mode)) with transitions })
    machine.modes;
  {
    machine with
    modes = List.filteri (fun k _ -> reached.(k)) machine.modes;
    start = renumber machine.start;
    controls = renumber machine.controls;
  }

let program (program : Ir.program) =
  if Array.exists (fun (node : Ir.node) -> Option.is_some node.machine) program.nodes then (
    let nodes = Array.copy program.nodes in
    Array.iteri
      (fun index (node : Ir.node) ->
        Option.iter
          (fun machine -> nodes.(index) <- { node with machine = Some (prune nodes machine) })
          node.machine)
      program.nodes;
    { program with nodes })
  else program
