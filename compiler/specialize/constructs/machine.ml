open Basis
module Ir = Flow.Ir

let bug format = Diagnostic.bug ~stage:"Specialize.Machine" format

type mode = {
  number : int;
  value : Value.t; (* its atoms belong to the node in which the mode was first found *)
  holes : Specialization_key.hole list;
  name : string;
  at : Span.t; (* the place that switches to it *)
  place : Span.t; (* the place of the code that the mode runs *)
  growth : Growth.t;
}

(* A mode and its node. *)
type built = {
  mode : mode;
  node : Node.t;
  statics : Ir.signal list;
  inputs : Ir.signal list;
  output : Value.t;
  transitions : Ir.transition list;
}

type machine = {
  context : Context.t;
  evaluator : Evaluator.t;
  trail : Context.trail;
  input : Core.Ir.ty;
  result : Core.Ir.ty;
  known : mode Variables.Table.t; (* modes by key *)
  count : Context.machine; (* shared with the trail *)
  waiting : mode Queue.t;
}

let position ?(in_mode = Fun.id) m node span : Evaluator.position =
  { context = m.context; trail = in_mode m.trail; types = m.context.types; node; span }

let signal_function m : Core.Ir.ty = Signal_function (m.input, m.result)
let unnamed span : Core.Ir.Local.t = { id = 0; name = ""; span }

(* {1 Finding modes} *)

(* Eta-reduces [proc x -> sf x] to [sf]. *)
let eta (proc : Core.Ir.proc) =
  match (proc.equations, proc.output.desc) with
  | ( [ { binder; rhs = Run { signal_function; input = { desc = Local input; _ } }; _ } ],
      Local output )
    when input.id = proc.input.local.id && output.id = binder.local.id ->
      Some signal_function
  | _, _ -> None

(* The alternatives for a signal function in tail position, with their conditions. *)
type choice = One of Value.t | If of Ir.atom * choice * choice

(* [input]: the input of this instant, if it is known that the chosen signal function runs on it
   immediately. *)
let rec choices m node ?input ~span (value : Value.t) =
  match value with
  | Choice { condition; then_; else_ } -> (
      match (then_, else_) with
      | Unspecified, other | other, Unspecified -> choices m node ?input ~span other
      | _, _ ->
          let then_ = choices m node ?input ~span then_ in
          If (condition, then_, choices m node ?input ~span else_))
  | Primitive { primitive = Run_task; types; arguments = [ task ]; owner; at } ->
      let run value : Value.t =
        Primitive { primitive = Run_task; types; arguments = [ { task with value } ]; owner; at }
      in
      let rec each : Value.t -> choice = function
        | Choice { condition; then_; else_ } ->
            let then_ = each then_ in
            If (condition, then_, each else_)
        | task -> One (run task)
      in
      each (Task.reduced (position m node span) m.evaluator ?input task.value)
  | Signal_function ({ code = Proc proc; _ } as closure) -> (
      match eta proc with
      | Some inner ->
          choices m node ?input ~span (m.evaluator.static (position m node span) closure inner)
      | None -> One value)
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Function _ | Primitive _
  | Signal_function _ | Program _ | Unspecified ->
      One value

(* The mode that runs the signal function, and the arguments for the mode's parameters. *)
let mode_of m node ~from ~at value =
  let walk = Specialization_key.walk m.context.keys node Holes in
  Specialization_key.add walk (unnamed at) (signal_function m) value;
  let holes = Specialization_key.take_holes walk in
  let key = Specialization_key.key walk in
  let mode =
    match Variables.Table.find_opt m.known key with
    | Some known -> known
    | None ->
        let name = Origin.mode_name value in
        let growth = Growth.of_value value ~at ~from in
        if Growth.is_endless growth then Growth.report m.context ~name growth;
        Context.count m.context m.trail ~name ~span:at;
        Context.check_lasting m.context m.trail ~span:at (Specialization_key.types holes);
        let place = Origin.mode_place ~otherwise:at value in
        let mode = { number = m.count.modes; value; holes; name; at; place; growth } in
        m.count.modes <- m.count.modes + 1;
        Variables.Table.replace m.known key mode;
        Queue.add mode m.waiting;
        mode
  in
  (mode, List.map (fun (hole : Specialization_key.hole) -> hole.atom) holes)

let both node ~span (a : Ir.atom) (b : Ir.atom) : Ir.atom =
  match (a, b) with
  | Bool true, other | other, Bool true -> other
  | _, _ -> Node.define node Unnamed ~span Bool (Op (And, [ a; b ]))

(* The transitions in order of priority: the first one that occurs is taken. *)
let transitions m node ?input ~from ~by ~span ~delayed occurs value =
  let rec go occurs choice rest =
    match choice with
    | If (condition, then_, else_) ->
        go (both node ~span occurs condition) then_ (go occurs else_ rest)
    | One value ->
        let mode, arguments = mode_of m node ~from ~at:span value in
        let target = mode.number in
        { Ir.occurs; target; arguments; delayed; at_entry = Possible; by; span } :: rest
  in
  match (occurs : Ir.atom) with
  | Bool false -> []
  | occurs -> go occurs (choices m node ?input ~span value) []

(* {1 Events} *)

(* Splits an event into a condition that is true if it occurs, and its value. [Event] is the second
   constructor. *)
let occurrence m node ~span ty event =
  let types = m.context.types in
  let occurs = Leaves.is_constructor types node Unnamed ~span (Core.Signature.event ty) event 1 in
  let value () =
    Leaves.payload types node Unnamed ~span (Core.Signature.event ty) event ~constructor:1 ~field:0
  in
  (occurs, value)

(* {1 Modes} *)

(* The proc that supplies the names for a mode's input; for a task, the proc of its first signal
   function. *)
let rec proc_of (value : Value.t) =
  match value with
  | Signal_function { code = Proc proc; types; _ }
  | Primitive
      {
        primitive = Switch | Delayed_switch;
        arguments = [ _; { value = Signal_function { code = Proc proc; types; _ }; _ } ];
        _;
      } ->
      Some (proc, types)
  | Primitive { primitive = Run_task; arguments = [ { value = task; _ } ]; _ } ->
      Option.bind (Task.first task) proc_of
  | _ -> None

(* The names that a mode uses for the machine's input. *)
let input_names m (value : Value.t) =
  match proc_of value with
  | Some (proc, types) -> (Destructuring.of_proc m.context.types types proc, Some proc.input.local)
  | None -> (Destructuring.none, None)

let parameter node ~name (hole : Specialization_key.hole) =
  Node.signal node ~name ~span:hole.local.span hole.ty

(* The output of a signal function in a mode. *)
let run_in m node (mode : mode) ~name ~result =
  let in_mode trail = Context.enter m.context trail ~name ~span:mode.at in
  m.evaluator.run (position ~in_mode m node mode.place) ~result

(* The transitions to the signal functions that the continuation of a switch returns for its
   event. *)
let after_event m node (mode : mode) input ~delayed ty event (continuation : Value.t) =
  let span = Origin.place ~otherwise:mode.place continuation in
  let occurs, payload = occurrence m node ~span ty event in
  match occurs with
  | Bool false -> []
  | _ ->
      let argument : Value.argument = { value = payload (); ty } in
      let after =
        let result = signal_function m in
        m.evaluator.apply (position m node span) ~result continuation [ argument ]
      in
      let by : Ir.follower =
        match continuation with
        | Function { name; _ } -> Continuation name
        | _ -> Continuation mode.name
      in
      transitions m node ~input ~from:(Some mode.growth) ~by ~span ~delayed occurs after

(* Returns the output of the task's first statement, whether the statement ends in this instant, and
   its result. *)
let statement m node (mode : mode) input primitive ~output ~result signal_function =
  let at = mode.place and types = m.context.types in
  let run = run_in m node mode ~name:mode.name in
  if primitive = Core.Primitive.Make_task then
    let both : Core.Ir.ty = Tuple [ output; Core.Signature.event result ] in
    let both = run ~result:both signal_function input in
    let occurs, ended = occurrence m node ~span:at result (Leaves.component both 1) in
    (Leaves.component both 0, occurs, ended)
  else
    let ty = Core.Signature.either output result in
    let either = run ~result:ty signal_function input in
    let part constructor =
      Leaves.payload types node Unnamed ~span:at ty either ~constructor ~field:0
    in
    let occurs = Leaves.is_constructor types node Unnamed ~span:at ty either 1 in
    (part 0, occurs, fun () -> part 1)

(* The output and transitions of [runTask task]; for any task [t], [runs t] is the value of
   [runTask t]. *)
let task_behaviour m node (mode : mode) ~(runs : Value.argument -> Value.t) (task : Value.argument)
    (input : Value.argument) =
  (* A machine for a single task returns the output and the result separately; a task that is a mode
     of a switch returns the same as [runTask]. *)
  let output ~shown ~has_ended ~ended : Value.t =
    match m.result with
    | Tuple _ -> Product [| shown; Atom (Bool has_ended); ended |]
    | _ when has_ended -> Constructed { constructor = 1; arguments = [ ended ] }
    | _ -> Constructed { constructor = 0; arguments = [ shown ] }
  in
  let follow occurs task after =
    let definition, span = Task.next task in
    transitions m node ~input ~from:(Some mode.growth) ~by:(Statement definition) ~span
      ~delayed:false occurs after
  in
  match Task.head task.value with
  | Ends result -> (output ~shown:Unspecified ~has_ended:true ~ended:result.value, [])
  | Passes ->
      ( output ~shown:Unspecified ~has_ended:false ~ended:Unspecified,
        follow (Bool true) task.value (runs task) )
  | Runs { signal_function; primitive; output = while_it_runs; result } ->
      let shown, occurs, ended =
        statement m node mode input primitive ~output:while_it_runs ~result signal_function
      in
      let left () =
        let result : Value.argument = { value = ended (); ty = result } in
        runs { task with value = Task.after task.value result }
      in
      let after = match occurs with Bool false -> [] | _ -> follow occurs task.value (left ()) in
      (output ~shown ~has_ended:false ~ended:Unspecified, after)

(* The output and transitions of a mode's signal function. *)
let behaviour m node (mode : mode) (value : Value.t) (input : Value.argument) =
  match value with
  | Primitive
      {
        primitive = (Switch | Delayed_switch) as primitive;
        arguments = [ continuation; before ];
        types = [ _; _; ty ];
        _;
      } ->
      let result : Core.Ir.ty = Tuple [ m.result; Core.Signature.event ty ] in
      let name = Core.Primitive_table.name primitive in
      let outputs = run_in m node mode ~name ~result before.value input in
      let delayed = primitive = Delayed_switch in
      let event = Leaves.component outputs 1 in
      ( Leaves.component outputs 0,
        after_event m node mode input ~delayed ty event continuation.value )
  | Primitive { primitive = Initially; arguments = [ chosen ]; _ } ->
      let event : Value.t = Constructed { constructor = 1; arguments = [ input.value ] } in
      (Unspecified, after_event m node mode input ~delayed:false input.ty event chosen.value)
  | Primitive ({ primitive = Run_task; arguments = [ task ]; _ } as runs) ->
      let runs task : Value.t = Primitive { runs with arguments = [ task ] } in
      task_behaviour m node mode ~runs task input
  | _ -> (run_in m node mode ~name:mode.name ~result:m.result value input, [])

let build m ~input_value ~input_holes (mode : mode) =
  let c = m.context in
  let node = Node.create ~fresh:c.fresh in
  let static (hole : Specialization_key.hole) =
    parameter node ~name:(Types.join hole.local.name hole.path) hole
  in
  let statics = List.map static mode.holes in
  let atoms = List.map (fun s -> Ir.Signal s) in
  let value =
    Specialization_key.value
      (Specialization_key.copy c.keys Holes (atoms statics))
      (signal_function m) mode.value
  in
  let names, local = input_names m value in
  let input (hole : Specialization_key.hole) =
    let own = Option.map (fun local -> Destructuring.name names local hole.path) local in
    match (own, hole.atom) with
    | (None | Some ""), Signal s -> parameter node ~name:s.name hole
    | own, _ -> parameter node ~name:(Option.value own ~default:"") hole
  in
  let inputs = List.map input input_holes in
  let input : Value.argument =
    {
      ty = m.input;
      value =
        Specialization_key.value
          (Specialization_key.copy c.keys Holes (atoms inputs))
          m.input input_value;
    }
  in
  let output, transitions = behaviour m node mode value input in
  { mode; node; statics; inputs; output; transitions }

let finish m name (b : built) outputs =
  let output (path, atom) = (Types.join "out" path, atom) in
  Specialization.finish m.context b.node
    ~name:(Names.unique m.context.names (Types.join name b.mode.name))
    ~origin:b.mode.name ~span:b.mode.place ~kind:Signal_function ~statics:b.statics ~inputs:b.inputs
    ~outputs:(List.map output outputs) ~transitions:b.transitions

(* {1 The machine} *)

(* The parts of a machine, in its own node. *)
type parts = {
  first : Value.t; (* the signal function that runs first *)
  own_input : Value.t; (* the input of the modes *)
  active : Ir.atom option;
  controls : unit -> Ir.transition list;
  complete : Value.t -> Value.t; (* computes the machine's output from the output of the modes *)
}

let parts m node ~span (value : Value.t) (input : Value.t) =
  let plain first own_input =
    { first; own_input; active = None; controls = (fun () -> []); complete = Fun.id }
  in
  match value with
  | Primitive
      {
        primitive = (Recurring_switch | Delayed_recurring_switch) as primitive;
        arguments = [ first ];
        _;
      } ->
      let event = Leaves.component input 1 in
      let controls () =
        let occurs, payload = occurrence m node ~span (signal_function m) event in
        match occurs with
        | Bool false -> []
        | _ ->
            transitions m node ~from:None ~by:(Continuation "") ~span
              ~delayed:(primitive = Delayed_recurring_switch)
              occurs (payload ())
      in
      { (plain first.value (Leaves.component input 0)) with controls }
  | Primitive { primitive = On_event; arguments = [ first ]; _ } ->
      let occurs, payload = occurrence m node ~span m.input input in
      let complete output =
        let event : Value.t = Constructed { constructor = 1; arguments = [ output ] } in
        let none : Value.t = Constructed { constructor = 0; arguments = [] } in
        match occurs with
        | Bool true -> event
        | Bool false -> none
        | occurs ->
            let ty = Core.Signature.event m.result in
            Leaves.select m.context.types node Unnamed ~span ty occurs event none
      in
      { (plain first.value (payload ())) with active = Some occurs; complete }
  | _ -> plain value input

let body ({ context = c; trail; node; span; _ } : Evaluator.position) evaluator ~name ~own_input
    ~own_result value input =
  let count : Context.machine = { of_ = name; place = span; modes = 0 } in
  let m =
    {
      context = c;
      evaluator;
      trail = Context.in_machine trail count;
      input = own_input;
      result = own_result;
      known = Variables.Table.create 16;
      count;
      waiting = Queue.create ();
    }
  in
  let parts = parts m node ~span value input in
  let input_value = parts.own_input in
  let walk = Specialization_key.walk c.keys node Holes in
  Specialization_key.add walk (unnamed span) m.input input_value;
  let input_holes = Specialization_key.take_holes walk in
  let start =
    transitions m node ~from:None ~by:(Continuation "") ~span ~delayed:false (Bool true) parts.first
  in
  let controls = parts.controls () in
  let rec all built =
    match Queue.take_opt m.waiting with
    | None -> List.rev built
    | Some mode -> all (build m ~input_value ~input_holes mode :: built)
  in
  let built = all [] in
  let given b : Mode_output.given = { node = b.node; place = b.mode.place; value = b.output } in
  let leaves b = Mode_output.leaves c own_result (given b) in
  let leaves = List.map leaves built in
  let variants = Mode_output.variants (List.map given built) leaves in
  let mode b leaves = finish m name b (Mode_output.of_mode c variants (given b) leaves) in
  let modes = List.map2 mode built leaves in
  let value, outputs = Mode_output.of_machine c node ~span own_result variants in
  Node.set_machine node
    {
      modes;
      start;
      active = parts.active;
      controls;
      inputs = List.map (fun (hole : Specialization_key.hole) -> hole.atom) input_holes;
      outputs;
      steps = 2 + List.length modes;
      span;
    };
  parts.complete value

(* Reports a machine that would be part of its own state. One of the machine's modes calls the
   function that, directly or through further calls, runs the machine again. *)
let refuse_nesting (c : Context.t) ~name ~is_task ~goes_on ~span ~outside ~inside =
  let calls = match Context.since outside inside with [] -> [] | _ :: calls -> List.rev calls in
  match calls with
  | [] -> bug "a machine is built again while it is being built"
  | _ :: _ -> Context.stop c (Restart (Inside_itself { at = span; name; is_task; goes_on; calls }))

let is_task : Value.t -> bool = function
  | Primitive { primitive = Run_task; _ } -> true
  | _ -> false

let goes_on : Value.t -> bool = function
  | Primitive { primitive = Recurring_switch | Delayed_recurring_switch; _ } -> true
  | _ -> false

let run (p : Evaluator.position) evaluator target ~result value (input : Value.argument) =
  let { Evaluator.context = c; trail; node; span; _ } = p in
  let name = Origin.name value in
  let span =
    match value with
    | Primitive { primitive = Run_task; arguments = [ { value = Primitive { at; _ }; _ } ]; _ }
      when Context.in_prelude c span ->
        at
    | _ -> span
  in
  let trail = Context.enter c trail ~name ~span in
  let own_input, own_result =
    match ((value, input.ty, result) : Value.t * Core.Ir.ty * Core.Ir.ty) with
    | Primitive { primitive = Recurring_switch | Delayed_recurring_switch; _ }, Tuple [ a; _ ], _ ->
        (a, result)
    | Primitive { primitive = On_event; _ }, Data (_, [ a ]), Data (_, [ b ]) -> (a, b)
    | _, _, _ -> (input.ty, result)
  in
  let ty : Core.Ir.ty = Signal_function (input.ty, result) in
  let walk = Specialization_key.walk c.keys node Holes in
  Specialization_key.add_number walk min_int;
  Specialization_key.add walk (unnamed span) ty value;
  let statics = Specialization_key.take_holes walk in
  let names, local =
    match proc_of value with
    | Some (proc, types) -> (Destructuring.of_proc c.types types proc, proc.input.local)
    | None -> (Destructuring.none, unnamed span)
  in
  Specialization_key.add walk local input.ty input.value;
  let inputs = Specialization_key.take_holes walk in
  let key = Specialization_key.key walk in
  Option.iter
    (fun outside ->
      refuse_nesting c ~name ~is_task:(is_task value) ~goes_on:(goes_on value) ~span ~outside
        ~inside:trail)
    (Variables.Table.find_opt c.building key);
  let make trail node atoms =
    let copy = Specialization_key.copy c.keys Holes atoms in
    let value = Specialization_key.value copy ty value in
    let input = Specialization_key.value copy input.ty input.value in
    Variables.Table.replace c.building key trail;
    Fun.protect
      ~finally:(fun () -> Variables.Table.remove c.building key)
      (fun () ->
        body { p with trail; node; span } evaluator ~name ~own_input ~own_result value input)
  in
  Specialization.call c trail node target
    { kind = Signal_function; name; span; call = span; result; statics; inputs; names; key }
    make
