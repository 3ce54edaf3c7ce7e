(* Callers come after what they call. *)
let called (nodes : Ir.node array) =
  let root = Array.length nodes - 1 in
  let called = Array.make (root + 1) false in
  called.(root) <- true;
  for index = root downto 0 do
    if called.(index) then begin
      List.iter (fun (i : Ir.instance) -> called.(i.node) <- true) nodes.(index).instances;
      let modes (m : Ir.machine) = List.iter (fun mode -> called.(mode) <- true) m.modes in
      Option.iter modes nodes.(index).machine
    end
  done;
  called

let numbers called =
  let next = ref (-1) in
  Array.map
    (fun called ->
      if called then incr next;
      !next)
    called

let renumber numbers (node : Ir.node) =
  let instance (i : Ir.instance) =
    if numbers.(i.node) = i.node then i else { i with node = numbers.(i.node) }
  in
  let machine (m : Ir.machine) = { m with modes = List.map (Array.get numbers) m.modes } in
  let instances = Basis.Long_list.map_sharing instance node.instances in
  if instances == node.instances && Option.is_none node.machine then node
  else { node with instances; machine = Option.map machine node.machine }

let program (program : Ir.program) =
  let called = called program.nodes in
  if Array.for_all Fun.id called then program
  else
    let numbers = numbers called in
    let kept = ref [] in
    for index = Array.length called - 1 downto 0 do
      if called.(index) then kept := renumber numbers program.nodes.(index) :: !kept
    done;
    { program with nodes = Array.of_list !kept }
