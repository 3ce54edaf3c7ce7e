(* An instance, with what the search has to know of it. *)
type instance = {
  callee : int;
  arguments : Ir.atom array;  (** statics, then inputs *)
  mutable needed : bool;
}

type definition =
  | Undefined
  | Parameter of { node : int; number : int }  (** statics, then inputs *)
  | Equation  (** see [right_sides] *)
  | Output of { instance : instance; number : int }
  | Mode_output of { owner : int; number : int }
  | Foreign_result of Ir.signal list  (** the node's inputs *)

(* A machine of the node, with what leads into its modes. *)
type machine = {
  modes : int array;
  inputs : Ir.atom array;
  arguments : Ir.atom list array array;
      (** by mode and static: what all transitions pass for it *)
  conditions : Ir.atom list;
  needed_inputs : bool array;
  mutable runs : bool;  (** is any output needed? *)
}

type node = {
  parameters : Ir.signal array;  (** statics, then inputs *)
  outputs : Ir.atom array;
  needed_outputs : bool array;
  mutable needed_instances : instance list;
  machine : machine option;
  mode_of : (machine * int) option;
  statics : int;  (** how many of the parameters *)
  accumulators : int;
      (** so many of the first inputs may come from the outputs of those numbers *)
}

type search = {
  definitions : definition array;  (** by signal id *)
  right_sides : Ir.rhs array;  (** by signal id, of those that equations define *)
  needed : Bytes.t;  (** by signal id: is it? *)
  nodes : node array;
}

let joined first second = Array.of_list (List.rev_append (List.rev first) second)

let machine (program : Ir.program) (machine : Ir.machine) : machine =
  let modes = Array.of_list machine.modes in
  let statics mode = List.length program.nodes.(mode).statics in
  let arguments = Array.map (fun mode -> Array.make (statics mode) []) modes in
  let conditions = ref (Option.to_list machine.active) in
  Transitions.into program machine (fun t ->
      conditions := t.occurs :: !conditions;
      let into = arguments.(t.target) in
      List.iteri (fun j a -> into.(j) <- a :: into.(j)) t.arguments);
  let inputs = Array.of_list machine.inputs in
  {
    modes;
    inputs;
    arguments;
    conditions = !conditions;
    needed_inputs = Array.make (Array.length inputs) false;
    runs = false;
  }

(* Of each node: in the loop over it that has most. *)
let accumulators (program : Ir.program) =
  let most = Array.make (Array.length program.nodes) 0 in
  let is_accumulator argument = argument = Ir.Accumulator in
  let note (i : Ir.instance) =
    match i.loop with
    | None -> ()
    | Some l ->
        most.(i.node) <- max most.(i.node) (List.length (List.filter is_accumulator l.arguments))
  in
  Array.iter (fun (node : Ir.node) -> List.iter note node.instances) program.nodes;
  most

let prepare (program : Ir.program) =
  let machines =
    Array.map (fun (node : Ir.node) -> Option.map (machine program) node.machine) program.nodes
  in
  let mode_of = Array.make (Array.length program.nodes) None in
  let own m = Array.iteri (fun k mode -> mode_of.(mode) <- Some (m, k)) m.modes in
  Array.iter (Option.iter own) machines;
  let accumulators = accumulators program in
  let definitions = Array.make program.next_id Undefined in
  let right_sides = Array.make program.next_id Ir.Absent in
  let define (s : Ir.signal) definition = definitions.(s.id) <- definition in
  let node index (node : Ir.node) =
    let parameters = joined node.statics node.inputs in
    Array.iteri (fun number s -> define s (Parameter { node = index; number })) parameters;
    List.iter
      (fun (e : Ir.equation) ->
        define e.defines Equation;
        right_sides.(e.defines.id) <- e.rhs)
      node.equations;
    List.iter
      (fun (i : Ir.instance) ->
        let instance =
          { callee = i.node; arguments = joined i.statics i.inputs; needed = false }
        in
        List.iteri (fun number s -> define s (Output { instance; number })) i.outputs)
      node.instances;
    Option.iter
      (fun (m : Ir.machine) ->
        List.iteri (fun number s -> define s (Mode_output { owner = index; number })) m.outputs)
      node.machine;
    Option.iter
      (fun (f : Ir.foreign) ->
        List.iter (fun s -> define s (Foreign_result node.inputs)) f.results)
      node.foreign;
    let outputs = Array.of_list (Basis.Long_list.map snd node.outputs) in
    {
      parameters;
      outputs;
      needed_outputs = Array.make (Array.length outputs) false;
      needed_instances = [];
      machine = machines.(index);
      mode_of = mode_of.(index);
      statics = List.length node.statics;
      accumulators = accumulators.(index);
    }
  in
  let nodes = Array.mapi node program.nodes in
  { definitions; right_sides; needed = Bytes.make program.next_id '\000'; nodes }

let is_needed search (s : Ir.signal) = Bytes.get search.needed s.id <> '\000'

(* [waiting]: signals that are needed, but not yet what follows from that. *)
let need search waiting (atom : Ir.atom) =
  match atom with
  | Signal s when not (is_needed search s) ->
      Bytes.set search.needed s.id '\001';
      s :: waiting
  | Signal _ | Bool _ | Int _ | Float _ -> waiting

(* Of a node: an accumulator is an input too. *)
let need_output search waiting callee number =
  if callee.needed_outputs.(number) then waiting
  else begin
    callee.needed_outputs.(number) <- true;
    let waiting = need search waiting callee.outputs.(number) in
    if number < callee.accumulators then
      need search waiting (Signal callee.parameters.(callee.statics + number))
    else waiting
  end

let need_parameter search waiting node number =
  let { mode_of; statics; needed_instances; accumulators; _ } = search.nodes.(node) in
  match mode_of with
  | None ->
      let waiting =
        if number >= statics && number - statics < accumulators then
          need_output search waiting search.nodes.(node) (number - statics)
        else waiting
      in
      List.fold_left
        (fun waiting (i : instance) -> need search waiting i.arguments.(number))
        waiting needed_instances
  | Some (machine, mode) when number < statics ->
      List.fold_left (need search) waiting machine.arguments.(mode).(number)
  | Some (machine, _) ->
      machine.needed_inputs.(number - statics) <- true;
      need search waiting machine.inputs.(number - statics)

let need_mode_output search waiting owner number =
  let machine = Option.get search.nodes.(owner).machine in
  let of_mode waiting mode =
    let mode = search.nodes.(mode) in
    mode.needed_outputs.(number) <- true;
    need search waiting mode.outputs.(number)
  in
  let waiting = Array.fold_left of_mode waiting machine.modes in
  if machine.runs then waiting
  else begin
    machine.runs <- true;
    List.fold_left (need search) waiting machine.conditions
  end

let need_instance search waiting (instance : instance) =
  if instance.needed then waiting
  else begin
    let callee = search.nodes.(instance.callee) in
    instance.needed <- true;
    callee.needed_instances <- instance :: callee.needed_instances;
    let waiting = ref waiting in
    Array.iteri
      (fun j a ->
        if is_needed search callee.parameters.(j) then waiting := need search !waiting a)
      instance.arguments;
    !waiting
  end

(* What is needed because this one is. *)
let consequences search waiting (s : Ir.signal) =
  match search.definitions.(s.id) with
  | Undefined -> Basis.Diagnostic.bug ~stage:"Flow.Dead_code" "`%s` (%d) is not defined" s.name s.id
  | Equation -> List.fold_left (need search) waiting (Operands.all search.right_sides.(s.id))
  | Parameter { node; number } -> need_parameter search waiting node number
  | Foreign_result inputs ->
      List.fold_left (fun waiting s -> need search waiting (Ir.Signal s)) waiting inputs
  | Mode_output { owner; number } -> need_mode_output search waiting owner number
  | Output { instance; number } ->
      let waiting = need_output search waiting search.nodes.(instance.callee) number in
      need_instance search waiting instance

let run search =
  let rec go = function
    | [] -> ()
    | s :: waiting -> go (consequences search waiting s)
  in
  let root = search.nodes.(Array.length search.nodes - 1) in
  Array.fill root.needed_outputs 0 (Array.length root.outputs) true;
  go (Array.fold_left (need search) [] root.outputs)

(* Which of several things are needed. *)
type flags = All | Some_of of bool list

let flags all = if List.for_all Fun.id all then All else Some_of all

(* Those of [items] that the flags are set for, pairwise. What is needed as a whole stays
   the very same, as most is. *)
let select flags items =
  match flags with
  | All -> items
  | Some_of flags ->
      List.rev
        (List.fold_left2 (fun all flag item -> if flag then item :: all else all) [] flags items)

let filter is_needed items =
  if List.for_all is_needed items then items else List.filter is_needed items

(* Of a node, by parameter and output: is it needed? *)
type interface = { of_statics : flags; of_inputs : flags; of_outputs : flags }

let interface search index (node : Ir.node) =
  let of_signals signals =
    if List.for_all (is_needed search) signals then All
    else Some_of (Basis.Long_list.map (is_needed search) signals)
  in
  {
    of_statics = of_signals node.statics;
    of_inputs = of_signals node.inputs;
    of_outputs = flags (Array.to_list search.nodes.(index).needed_outputs);
  }

(* The nodes that stay, by their new numbers; -1 for others. *)
let renumber search =
  let root = Array.length search.nodes - 1 in
  let count = ref 0 in
  Array.mapi
    (fun index (node : node) ->
      let runs = Option.fold node.mode_of ~none:false ~some:(fun (m, _) -> m.runs) in
      if index = root || node.needed_instances <> [] || runs then begin
        incr count;
        !count - 1
      end
      else -1)
    search.nodes

let sweep search (program : Ir.program) =
  let root = Array.length program.nodes - 1 in
  let is_needed = is_needed search in
  let numbers = renumber search in
  let interfaces = Array.mapi (interface search) program.nodes in
  let trial (i : Ir.instance) (trial : Ir.trial) =
    let { of_inputs; of_outputs; _ } = interfaces.(i.node) in
    let given = select of_outputs i.outputs in
    let is_given (s : Ir.signal) = List.exists (fun (g : Ir.signal) -> g.id = s.id) given in
    match List.filter is_given trial.gives with
    | [] -> None
    | gives -> Some { Ir.gives; given = select of_inputs trial.given }
  in
  let instance (i : Ir.instance) =
    match interfaces.(i.node) with
    | { of_statics = All; of_inputs = All; of_outputs = All } when numbers.(i.node) = i.node -> i
    | { of_statics; of_inputs; of_outputs } ->
        {
          i with
          node = numbers.(i.node);
          statics = select of_statics i.statics;
          inputs = select of_inputs i.inputs;
          outputs = select of_outputs i.outputs;
          trials = List.filter_map (trial i) i.trials;
          loop =
            Option.map
              (fun (l : Ir.loop) -> { l with arguments = select of_inputs l.arguments })
              i.loop;
        }
  in
  let transitions modes =
    List.map (fun (t : Ir.transition) ->
        { t with arguments = select interfaces.(modes.(t.target)).of_statics t.arguments })
  in
  let machine (known : machine) (m : Ir.machine) =
    if not known.runs then None
    else
      let needed_outputs =
        match m.modes with mode :: _ -> interfaces.(mode).of_outputs | [] -> All
      in
      Some
        {
          m with
          modes = List.map (fun mode -> numbers.(mode)) m.modes;
          start = transitions known.modes m.start;
          controls = transitions known.modes m.controls;
          inputs = select (flags (Array.to_list known.needed_inputs)) m.inputs;
          outputs = select needed_outputs m.outputs;
        }
  in
  let node index (node : Ir.node) =
    let { of_statics; of_inputs; of_outputs } = interfaces.(index) in
    let is_root = index = root in
    let mode_of = search.nodes.(index).mode_of in
    let statics = if is_root then node.statics else select of_statics node.statics in
    let inputs =
      match mode_of with
      | Some (machine, _) -> select (flags (Array.to_list machine.needed_inputs)) node.inputs
      | None -> if is_root then node.inputs else select of_inputs node.inputs
    in
    let outputs = select of_outputs node.outputs in
    let equations = filter (fun (e : Ir.equation) -> is_needed e.defines) node.equations in
    let is_used (i : Ir.instance) = List.exists is_needed i.outputs in
    let instances = Basis.Long_list.map_sharing instance (filter is_used node.instances) in
    let has_transitions = Option.is_some node.machine || node.transitions <> [] in
    if
      (not has_transitions) && statics == node.statics && inputs == node.inputs
      && outputs == node.outputs && equations == node.equations && instances == node.instances
    then node
    else
      {
        node with
        statics;
        inputs;
        outputs;
        equations;
        instances;
        machine =
          Option.bind node.machine (fun m -> machine (Option.get search.nodes.(index).machine) m);
        transitions =
          (match mode_of with
          | Some (machine, _) -> transitions machine.modes node.transitions
          | None -> []);
      }
  in
  let swept = ref [] in
  for index = root downto 0 do
    if numbers.(index) >= 0 then swept := node index program.nodes.(index) :: !swept
  done;
  { program with nodes = Array.of_list !swept }

let program program =
  let search = prepare program in
  run search;
  sweep search program
