(* An instance, with what the search has to know of it. *)
type instance = {
  callee : int;
  arguments : Ir.atom array;  (** statics, then inputs *)
  mutable needed : bool;
}

type definition =
  | Undefined
  | Parameter of { node : int; number : int }  (** statics, then inputs *)
  | Equation of Ir.rhs
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
  let define (s : Ir.signal) definition = definitions.(s.id) <- definition in
  let node index (node : Ir.node) =
    let parameters = joined node.statics node.inputs in
    Array.iteri (fun number s -> define s (Parameter { node = index; number })) parameters;
    List.iter (fun (e : Ir.equation) -> define e.defines (Equation e.rhs)) node.equations;
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
  { definitions; needed = Bytes.make program.next_id '\000'; nodes }

let is_needed search (s : Ir.signal) = Bytes.get search.needed s.id <> '\000'

(* The atoms that are needed because a node's output is: an accumulator is an
   input too. *)
let output callee number : Ir.atom list =
  if callee.needed_outputs.(number) then []
  else (
    callee.needed_outputs.(number) <- true;
    let own = [ callee.outputs.(number) ] in
    if number < callee.accumulators then
      Ir.Signal callee.parameters.(callee.statics + number) :: own
    else own)

(* The atoms that are needed because this one is. *)
let consequences search (s : Ir.signal) =
  match search.definitions.(s.id) with
  | Undefined -> Basis.Diagnostic.bug ~stage:"Flow.Dead" "`%s` (%d) is not defined" s.name s.id
  | Equation rhs -> Operands.all rhs
  | Parameter { node; number } -> (
      let { mode_of; statics; needed_instances; accumulators; _ } = search.nodes.(node) in
      match mode_of with
      | None ->
          let next =
            if number >= statics && number - statics < accumulators then
              output search.nodes.(node) (number - statics)
            else []
          in
          List.rev_append
            (List.rev_map (fun (i : instance) -> i.arguments.(number)) needed_instances)
            next
      | Some (machine, mode) when number < statics -> machine.arguments.(mode).(number)
      | Some (machine, _) ->
          machine.needed_inputs.(number - statics) <- true;
          [ machine.inputs.(number - statics) ])
  | Foreign_result inputs -> List.map (fun s -> Ir.Signal s) inputs
  | Mode_output { owner; number } ->
      let machine = Option.get search.nodes.(owner).machine in
      let outputs mode =
        let mode = search.nodes.(mode) in
        mode.needed_outputs.(number) <- true;
        mode.outputs.(number)
      in
      let outputs = Array.to_list (Array.map outputs machine.modes) in
      if machine.runs then outputs
      else (
        machine.runs <- true;
        List.rev_append outputs machine.conditions)
  | Output { instance; number } ->
      let callee = search.nodes.(instance.callee) in
      let output = output callee number in
      if instance.needed then output
      else begin
        instance.needed <- true;
        callee.needed_instances <- instance :: callee.needed_instances;
        let passed = ref output in
        Array.iteri
          (fun j a -> if is_needed search callee.parameters.(j) then passed := a :: !passed)
          instance.arguments;
        !passed
      end

let run search =
  let rec go = function
    | [] -> ()
    | Ir.Signal s :: rest when not (is_needed search s) ->
        Bytes.set search.needed s.id '\001';
        go (List.rev_append (consequences search s) rest)
    | (Ir.Signal _ | Bool _ | Int _ | Float _) :: rest -> go rest
  in
  let root = search.nodes.(Array.length search.nodes - 1) in
  Array.fill root.needed_outputs 0 (Array.length root.outputs) true;
  go (Array.to_list root.outputs)

(* Those of [items] whose [flags] are set, pairwise. What is needed as a whole stays
   the very same, as most is. *)
let select flags items =
  if List.for_all Fun.id flags then items
  else
    List.rev
      (List.fold_left2 (fun all flag item -> if flag then item :: all else all) [] flags items)

let filter is_needed items =
  if List.for_all is_needed items then items else List.filter is_needed items

(* Of a node, by parameter and output: is it needed? *)
type interface = { of_statics : bool list; of_inputs : bool list; of_outputs : bool list }

let interface search index (node : Ir.node) =
  let flags = Basis.Long_list.map (is_needed search) in
  {
    of_statics = flags node.statics;
    of_inputs = flags node.inputs;
    of_outputs = Array.to_list search.nodes.(index).needed_outputs;
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
  let is_given (i : Ir.instance) (s : Ir.signal) =
    List.exists2
      (fun is_needed (output : Ir.signal) -> is_needed && output.id = s.id)
      interfaces.(i.node).of_outputs i.outputs
  in
  let instance (i : Ir.instance) =
    let { of_statics; of_inputs; of_outputs } = interfaces.(i.node) in
    {
      i with
      node = numbers.(i.node);
      statics = select of_statics i.statics;
      inputs = select of_inputs i.inputs;
      outputs = select of_outputs i.outputs;
      trials =
        List.filter_map
          (fun (trial : Ir.trial) ->
            match List.filter (is_given i) trial.gives with
            | [] -> None
            | gives -> Some { Ir.gives; given = select of_inputs trial.given })
          i.trials;
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
        match m.modes with mode :: _ -> interfaces.(mode).of_outputs | [] -> []
      in
      Some
        {
          m with
          modes = List.map (fun mode -> numbers.(mode)) m.modes;
          start = transitions known.modes m.start;
          controls = transitions known.modes m.controls;
          inputs = select (Array.to_list known.needed_inputs) m.inputs;
          outputs = select needed_outputs m.outputs;
        }
  in
  let node index (node : Ir.node) =
    let { of_statics; of_inputs; of_outputs } = interfaces.(index) in
    let instances =
      filter (fun (i : Ir.instance) -> List.exists is_needed i.outputs) node.instances
    in
    {
      node with
      statics = (if index = root then node.statics else select of_statics node.statics);
      inputs =
        (match search.nodes.(index).mode_of with
        | Some (machine, _) -> select (Array.to_list machine.needed_inputs) node.inputs
        | None -> if index = root then node.inputs else select of_inputs node.inputs);
      outputs = select of_outputs node.outputs;
      equations = filter (fun (e : Ir.equation) -> is_needed e.defines) node.equations;
      instances = Basis.Long_list.map instance instances;
      machine = Option.bind node.machine (fun m -> machine (Option.get search.nodes.(index).machine) m);
      transitions =
        (match search.nodes.(index).mode_of with
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
