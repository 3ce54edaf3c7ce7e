open Basis

type call = { callee : int; arguments : (Ir.argument * Ir.atom) array }

let each_as_given = List.map (fun a -> (Ir.Same, a))

let calls (program : Ir.program) =
  let found = ref [] in
  let call callee arguments = found := { callee; arguments = Array.of_list arguments } :: !found in
  let instance (i : Ir.instance) =
    let inputs =
      match i.loop with
      | None -> each_as_given i.inputs
      | Some l -> List.combine l.arguments i.inputs
    in
    call i.node (each_as_given i.statics @ inputs)
  in
  let machine (m : Ir.machine) =
    let modes = Array.of_list m.modes in
    let transition inputs (t : Ir.transition) =
      call modes.(t.target) (each_as_given (t.arguments @ inputs))
    in
    List.iter (transition m.inputs) (m.start @ m.controls);
    let from_mode mode =
      let node = program.nodes.(mode) in
      List.iter (transition (List.map (fun s -> Ir.Signal s) node.inputs)) node.transitions
    in
    Array.iter from_mode modes
  in
  let node (node : Ir.node) =
    List.iter instance node.instances;
    Option.iter machine node.machine
  in
  Array.iter node program.nodes;
  !found

let parameters (node : Ir.node) = Array.of_list (node.statics @ node.inputs)

let places (program : Ir.program) =
  let places = Int_table.create 64 in
  let place k j (s : Ir.signal) = Int_table.replace places s.id (k, j) in
  Array.iteri (fun k node -> Array.iteri (place k) (parameters node)) program.nodes;
  fun (atom : Ir.atom) ->
    match atom with Signal s -> Int_table.find_opt places s.id | Bool _ | Int _ | Float _ -> None

let settle (program : Ir.program) visit =
  let calls = Array.of_list (calls program) and place = places program in
  (* For each node, the calls in it that pass on one of its own parameters. *)
  let passing_on = Array.make (Array.length program.nodes) [] in
  let note call (_, atom) =
    match place atom with Some (k, _) -> passing_on.(k) <- call :: passing_on.(k) | None -> ()
  in
  Array.iteri (fun call { arguments; _ } -> Array.iter (note call) arguments) calls;
  let queue = Queue.create () and waits = Array.make (Array.length calls) false in
  let enqueue call =
    if not waits.(call) then (
      waits.(call) <- true;
      Queue.add call queue)
  in
  Array.iteri (fun call _ -> enqueue call) calls;
  while not (Queue.is_empty queue) do
    let call = Queue.pop queue in
    waits.(call) <- false;
    if visit calls.(call) then List.iter enqueue passing_on.(calls.(call).callee)
  done

let replaced (program : Ir.program) replacement =
  let node k node =
    let substitution = Substitution.create () in
    let replace j s = Option.iter (Substitution.replace substitution s) (replacement k j) in
    Array.iteri replace (parameters node);
    Substitution.node substitution node
  in
  let nodes = Array.mapi node program.nodes in
  if Array.for_all2 ( == ) nodes program.nodes then program else { program with nodes }
