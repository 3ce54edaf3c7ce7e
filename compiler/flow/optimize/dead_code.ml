open Basis

(* For each node, the maximum number of accumulators in any loop that runs it. Only that many of its
   inputs, starting with the first, can be fed back from the output with the same index. *)
let accumulators (program : Ir.program) =
  let most = Array.make (Array.length program.nodes) 0 in
  let is_accumulator argument = argument = Ir.Accumulator in
  let note (i : Ir.instance) =
    let count (l : Ir.loop) = List.length (List.filter is_accumulator l.arguments) in
    most.(i.node) <- max most.(i.node) (Option.fold i.loop ~none:0 ~some:count)
  in
  Array.iter (fun (node : Ir.node) -> List.iter note node.instances) program.nodes;
  most

type found = {
  needed : Bytes.t;  (** whether a signal is needed, by id *)
  outputs : bool array array;  (** whether an output is needed, by node and index *)
  runs : bool array;  (** whether anything needed runs the node *)
}

let is_needed found (s : Ir.signal) = Bytes.get found.needed s.id <> '\000'
let undefined () = Diagnostic.bug ~stage:"Flow.Dead_code" "a signal that is not defined"

(* For each signal, by id, a function that returns the signals that are needed if this signal
   is needed. The function is called at most once. *)
let consequences found (program : Ir.program) =
  let nodes = program.nodes in
  let of_nodes f = Array.map f nodes in
  let statics = of_nodes (fun (n : Ir.node) -> List.length n.statics) in
  let parameters = of_nodes (fun (n : Ir.node) -> Array.of_list (n.statics @ n.inputs)) in
  let results = of_nodes (fun (n : Ir.node) -> Array.of_list (Long_list.map snd n.outputs)) in
  let accumulators = accumulators program and owners = Transitions.owners program in
  (* The arguments that the needed instances of each node pass to it. *)
  let passed = Array.make (Array.length nodes) [] in
  let consequences = Array.make program.next_id undefined in
  let define (s : Ir.signal) why = consequences.(s.id) <- why in
  (* If the output of an accumulator is needed, its input is needed, too. *)
  let output k number =
    found.outputs.(k).(number) <- true;
    results.(k).(number)
    ::
    (if number < accumulators.(k) then [ Ir.Signal parameters.(k).(statics.(k) + number) ] else [])
  in
  let parameter k number () =
    let accumulator = number - statics.(k) in
    (if accumulator >= 0 && accumulator < accumulators.(k) then output k accumulator else [])
    @ List.map (fun arguments -> arguments.(number)) passed.(k)
  in
  let instance (i : Ir.instance) =
    let arguments = Array.of_list (i.statics @ i.inputs) and run = ref false in
    let start () =
      run := true;
      found.runs.(i.node) <- true;
      passed.(i.node) <- arguments :: passed.(i.node);
      let is_read number _ = is_needed found parameters.(i.node).(number) in
      List.filteri is_read (Array.to_list arguments)
    in
    let why number () = output i.node number @ if !run then [] else start () in
    List.iteri (fun number s -> define s (why number)) i.outputs
  in
  let machine (m : Ir.machine) =
    let modes = Array.of_list m.modes in
    let conditions = ref (Option.to_list m.active) in
    let given = Array.map (fun mode -> Array.make statics.(mode) []) modes in
    Transitions.into program m (fun t ->
        conditions := t.occurs :: !conditions;
        let into = given.(t.target) in
        List.iteri (fun number a -> into.(number) <- a :: into.(number)) t.arguments);
    let inputs = Array.of_list m.inputs in
    let of_mode k mode =
      Array.iteri
        (fun number s ->
          define s (fun () ->
              if number < statics.(mode) then given.(k).(number)
              else [ inputs.(number - statics.(mode)) ]))
        parameters.(mode)
    in
    Array.iteri of_mode modes;
    let why number () =
      List.iter (fun mode -> found.runs.(mode) <- true) m.modes;
      List.concat_map (fun mode -> output mode number) m.modes @ !conditions
    in
    List.iteri (fun number s -> define s (why number)) m.outputs
  in
  let node k (node : Ir.node) =
    let equation (e : Ir.equation) = define e.defines (fun () -> Operands.all e.rhs) in
    let inputs () = Long_list.map (fun s -> Ir.Signal s) node.inputs in
    let result s = define s inputs in
    if owners.(k) = None then
      Array.iteri (fun number s -> define s (parameter k number)) parameters.(k);
    List.iter equation node.equations;
    List.iter instance node.instances;
    Option.iter machine node.machine;
    Option.iter (fun (f : Ir.foreign) -> List.iter result f.results) node.foreign
  in
  Array.iteri node nodes;
  consequences

let find (program : Ir.program) =
  let root = Array.length program.nodes - 1 in
  let all (node : Ir.node) = Array.make (List.length node.outputs) false in
  let found =
    {
      needed = Bytes.make program.next_id '\000';
      outputs = Array.map all program.nodes;
      runs = Array.map (fun _ -> false) program.nodes;
    }
  in
  let consequences = consequences found program in
  let need waiting (atom : Ir.atom) =
    match atom with
    | Signal s when not (is_needed found s) ->
        Bytes.set found.needed s.id '\001';
        s :: waiting
    | Signal _ | Bool _ | Int _ | Float _ -> waiting
  in
  let rec go = function
    | [] -> ()
    | (s : Ir.signal) :: waiting -> go (List.fold_left need waiting (consequences.(s.id) ()))
  in
  found.runs.(root) <- true;
  Array.fill found.outputs.(root) 0 (Array.length found.outputs.(root)) true;
  go (List.fold_left need [] (Long_list.map snd program.nodes.(root).outputs));
  found

(* The items whose flags are set. The result is physically equal to the list if all flags are set,
   which is the usual case. *)
let select flags items =
  let add all flag item = if flag then item :: all else all in
  if List.for_all Fun.id flags then items else List.rev (List.fold_left2 add [] flags items)

let filter is_needed items =
  if List.for_all is_needed items then items else List.filter is_needed items

type sweep = {
  found : found;
  numbers : int array;  (** new indices of the nodes *)
  owners : int option array;  (** for a mode, the node with its machine *)
  modes : int array array;  (** the modes of each node's machine *)
  of_statics : bool list array;  (** the needed static parameters of each node *)
  of_inputs : bool list array;
  of_outputs : bool list array;
}

(* The needed inputs of each node. All modes of a machine must have the same inputs, and the root
   keeps all of its inputs. *)
let needed_inputs found (program : Ir.program) owners =
  let root = Array.length program.nodes - 1 in
  let flags (node : Ir.node) = Long_list.map (is_needed found) node.inputs in
  let either a b = List.rev (List.rev_map2 ( || ) a b) in
  let of_machines = Int_table.create 16 in
  let of_machine owner (m : Ir.machine) own =
    match Int_table.find_opt of_machines owner with
    | Some all -> all
    | None ->
        let all =
          List.fold_left (fun all mode -> either all (flags program.nodes.(mode))) own m.modes
        in
        Int_table.replace of_machines owner all;
        all
  in
  let inputs k node =
    let own = flags node in
    match Option.map (fun owner -> (owner, program.nodes.(owner).machine)) owners.(k) with
    | Some (owner, Some m) -> of_machine owner m own
    | Some (_, None) | None -> if k = root then List.map (fun _ -> true) own else own
  in
  Array.mapi inputs program.nodes

let start_sweep found (program : Ir.program) =
  let count = ref (-1) in
  let number runs =
    if runs then incr count;
    !count
  in
  let owners = Transitions.owners program in
  let statics (node : Ir.node) = Long_list.map (is_needed found) node.statics in
  let modes (node : Ir.node) =
    Option.fold node.machine ~none:[||] ~some:(fun (m : Ir.machine) -> Array.of_list m.modes)
  in
  {
    found;
    numbers = Array.map number found.runs;
    owners;
    modes = Array.map modes program.nodes;
    of_statics = Array.map statics program.nodes;
    of_inputs = needed_inputs found program owners;
    of_outputs = Array.map Array.to_list found.outputs;
  }

let sweep_trial sweep (i : Ir.instance) (trial : Ir.trial) =
  let given = select sweep.of_outputs.(i.node) i.outputs in
  let is_given (s : Ir.signal) = List.exists (fun (g : Ir.signal) -> g.id = s.id) given in
  match List.filter is_given trial.gives with
  | [] -> None
  | gives -> Some { Ir.gives; given = select sweep.of_inputs.(i.node) trial.given }

let sweep_instance sweep (i : Ir.instance) =
  let k = i.node in
  let statics = select sweep.of_statics.(k) i.statics in
  let inputs = select sweep.of_inputs.(k) i.inputs in
  let outputs = select sweep.of_outputs.(k) i.outputs in
  let is_whole = statics == i.statics && inputs == i.inputs && outputs == i.outputs in
  if is_whole && sweep.numbers.(k) = k then i
  else
    let loop (l : Ir.loop) = { l with arguments = select sweep.of_inputs.(k) l.arguments } in
    let trials = List.filter_map (sweep_trial sweep i) i.trials in
    {
      i with
      node = sweep.numbers.(k);
      statics;
      inputs;
      outputs;
      trials;
      loop = Option.map loop i.loop;
    }

(* [owner]: the node with the machine. *)
let sweep_transitions sweep owner =
  let modes = sweep.modes.(owner) in
  List.map (fun (t : Ir.transition) ->
      { t with arguments = select sweep.of_statics.(modes.(t.target)) t.arguments })

let sweep_machine sweep k (m : Ir.machine) =
  let mode = List.hd m.modes in
  if not sweep.found.runs.(mode) then None
  else
    Some
      {
        m with
        modes = List.map (fun mode -> sweep.numbers.(mode)) m.modes;
        start = sweep_transitions sweep k m.start;
        controls = sweep_transitions sweep k m.controls;
        inputs = select sweep.of_inputs.(mode) m.inputs;
        outputs = select sweep.of_outputs.(mode) m.outputs;
      }

let sweep_node sweep k (node : Ir.node) =
  let is_needed = is_needed sweep.found in
  let is_used (i : Ir.instance) = List.exists is_needed i.outputs in
  let statics = select sweep.of_statics.(k) node.statics in
  let inputs = select sweep.of_inputs.(k) node.inputs in
  let outputs = select sweep.of_outputs.(k) node.outputs in
  let equations = filter (fun (e : Ir.equation) -> is_needed e.defines) node.equations in
  let instances = Long_list.map_sharing (sweep_instance sweep) (filter is_used node.instances) in
  if
    node.machine = None && node.transitions = [] && statics == node.statics && inputs == node.inputs
    && outputs == node.outputs && equations == node.equations && instances == node.instances
  then node
  else
    let machine = Option.bind node.machine (sweep_machine sweep k) in
    let transitions =
      match sweep.owners.(k) with
      | Some owner -> sweep_transitions sweep owner node.transitions
      | None -> []
    in
    { node with statics; inputs; outputs; equations; instances; machine; transitions }

let sweep found (program : Ir.program) =
  let sweep = start_sweep found program in
  let nodes = Array.to_list (Array.mapi (sweep_node sweep) program.nodes) in
  { program with nodes = Array.of_list (List.filteri (fun k _ -> found.runs.(k)) nodes) }

let program program = sweep (find program) program
