module F = Flow.Ir
open Basis
open Fragment
open Computation

type context = {
  program : F.program;
  statics : Statics.t array;
  done_ : Ir.node option array;  (** the nodes already translated *)
  sees_first_dt : bool array;
  is_limited : int -> bool;  (** see {!Flow.Time_limit} *)
  mutable fresh : int;  (** larger than every id of a signal *)
}

let callee context k =
  match context.done_.(k) with
  | Some node -> node
  | None -> Diagnostic.bug ~stage:"Machine.Of_flow" "a node is used before it is known"

let variable = Modes.variable

let broken what = Diagnostic.bug ~stage:"Machine.Of_flow" "%s" what

(* The arguments for those parameters that the callee reads. *)
let arguments context (i : F.instance) (code : Ir.code) =
  let node = context.program.nodes.(i.node) in
  let given = Int_table.create 16 in
  let add (s : F.signal) atom = Int_table.replace given s.id atom in
  List.iter2 add node.statics i.statics;
  List.iter2 add node.inputs i.inputs;
  List.map
    (fun (parameter : Ir.variable) ->
      match Int_table.find_opt given parameter.id with
      | Some atom -> atom
      | None -> broken "a parameter that is neither static nor input")
    code.parameters

(* Variables for all outputs of an instance, those of others than [defines]
   being of no use. *)
let results context (i : F.instance) defines =
  let variable_for (s : F.signal) =
    if List.exists (fun (d : F.signal) -> d.id = s.id) defines then variable s
    else (
      context.fresh <- context.fresh + 1;
      { (variable s) with id = context.fresh; name = "" })
  in
  List.map variable_for i.outputs

let rec zero context (ty : F.ty) : Ir.expr =
  match ty with
  | Bool -> Bool false
  | Int -> Int 0l
  | Float -> Float 0.
  | Sum sum -> (
      match context.program.sums.(sum).constructors with
      | first :: _ ->
          let payload = List.map (zero context) (Layout.leaves first) in
          Construct { sum; constructor = 0; payload }
      | [] -> broken "a sum without constructors")
  | Array (count, element) ->
      Fill { count; element = Layout.ty element; value = zero context element }
  | Foreign ty -> Absent ty

(* A step of a copy. What is not given is zero. *)
let try_out context resolve (i : F.instance) (trial : F.trial) state =
  let node = callee context i.node in
  let given = List.combine context.program.nodes.(i.node).inputs trial.given in
  let missing =
    List.filter_map (fun ((s : F.signal), a) -> if Option.is_none a then Some s.id else None) given
  in
  let atoms = List.combine node.step.parameters (arguments context i node.step) in
  let is_given ((v : Ir.variable), _) = not (List.mem v.id missing) in
  let operands = List.map (fun (_, atom) -> resolve atom) (List.filter is_given atoms) in
  let results = results context i trial.gives in
  let zeros =
    List.filter_map
      (fun ((s : F.signal), a) -> if Option.is_none a then Some (s.id, zero context s.ty) else None)
      given
  in
  (* Arrays are passed by address, so they need variables. *)
  let declare (id, (value : Ir.expr)) =
    match value with
    | Fill { count; element; _ } ->
        context.fresh <- context.fresh + 1;
        let variable : Ir.variable =
          { id = context.fresh; name = ""; ty = Array (count, element) }
        in
        ((id, Ir.Variable variable), [ Ir.Declare { variable; value; span = i.span } ])
    | value -> ((id, value), [])
  in
  let zeros, declared = List.split (List.map declare zeros) in
  let declared = List.concat declared in
  let rec fill parameters exprs =
    match (parameters, exprs) with
    | [], _ -> []
    | ((v : Ir.variable), _) :: parameters, exprs -> (
        match (List.assoc_opt v.id zeros, exprs) with
        | Some zero, _ -> zero :: fill parameters exprs
        | None, e :: exprs -> e :: fill parameters exprs
        | None, [] -> broken "a trial without an argument")
  in
  let statements exprs =
    let arguments = fill atoms exprs in
    declared
    @ [ Ir.Step { node = i.node; state; arguments; results; on_trial = true; span = i.span } ]
  in
  Action
    {
      defines = trial.gives;
      operands;
      statements;
      always = true;
      weight = 2 + node.operations;
      span = i.span;
    }

let loop context resolve (i : F.instance) (l : F.loop) state =
  let node = callee context i.node in
  let forms = Int_table.create 16 in
  let input k (s : F.signal) form = Int_table.replace forms s.id (k, form) in
  List.iteri
    (fun k (s, form) -> input k s form)
    (List.combine context.program.nodes.(i.node).inputs l.arguments);
  let initial =
    List.filteri (fun k _ -> List.nth l.arguments k = F.Accumulator) i.inputs
  in
  let parameters = node.step.parameters in
  let form (p : Ir.variable) =
    Option.value (Int_table.find_opt forms p.id) ~default:(0, F.Same)
  in
  let statements exprs =
    let accumulators = List.length initial in
    let first = List.filteri (fun k _ -> k < accumulators) exprs in
    let others = List.filteri (fun k _ -> k >= accumulators) exprs in
    let argument p e : Ir.argument =
      match form p with
      | k, Accumulator -> Accumulated k
      | _, Element -> Each e
      | _, Same -> Same e
      | _, Counter -> Counted e
    in
    [
      Ir.Loop
        {
          node = i.node;
          state;
          count = l.count;
          initial = first;
          arguments = List.map2 argument parameters others;
          results = List.map variable i.outputs;
          span = i.span;
        };
    ]
  in
  Action
    {
      defines = i.outputs;
      operands = List.map resolve (initial @ arguments context i node.step);
      statements;
      always = Option.is_some state;
      weight = l.count * (2 + node.operations);
      span = i.span;
    }

let call context resolve (i : F.instance) state =
  let node = callee context i.node in
  let operands = List.map resolve (arguments context i node.step) in
  match (i.loop, state, i.outputs) with
  | Some l, _, _ -> loop context resolve i l state
  | None, None, [ signal ] when i.trials = [] ->
      let build arguments = Ir.Call { node = i.node; arguments } in
      Computed
        { signal; operands; build; choice = None; weight = 2 + node.operations; span = i.span }
  | None, _, _ ->
      let defines = Flow.Schedule.defines (Instance i) in
      let results = results context i defines in
      let statements arguments =
        [ Ir.Step { node = i.node; state; arguments; results; on_trial = false; span = i.span } ]
      in
      Action
        {
          defines;
          operands;
          statements;
          always = Option.is_some state;
          weight = 2 + node.operations;
          span = i.span;
        }

(* A fragment under construction. Unnamed copies are looked through. *)
type draft = {
  copies : F.atom Int_table.t;
  leaves : Ir.expr Int_table.t;
  mutable items : item list;  (** last first *)
  mutable states : (Ir.field * F.atom * F.signal option * Span.t) list;
      (** besides those of {!next_state} *)
}

let draft () = { copies = Int_table.create 16; leaves = Int_table.create 16; items = []; states = [] }
let add draft item = draft.items <- item :: draft.items
let leaf draft (s : F.signal) e = Int_table.replace draft.leaves s.id e

let resolve draft (atom : F.atom) =
  match atom with
  | Signal s -> Option.value (Int_table.find_opt draft.copies s.id) ~default:atom
  | Bool _ | Int _ | Float _ -> atom

let add_computed draft (eq : F.equation) =
  match without_self_comparison (Flow.Operands.map (resolve draft) eq.rhs) with
  | Copy atom when String.equal eq.defines.name "" ->
      Int_table.replace draft.copies eq.defines.id atom
  | rhs -> add draft (Computed (computed eq rhs))

let work ?(operands = []) span statements =
  Action { defines = []; operands; statements; always = true; weight = 0; span }

let differentiate draft ~(value : Ir.field) ~(input : Ir.field) atom span =
  let statements = function
    | [ now; kept ] ->
        let change = operation F.Subtract Float [ now; Ir.Field input ] in
        [
          Ir.If
            {
              uninitialized = [];
              condition = operation F.Less Float [ Float 0.; Dt ];
              then_ =
                [
                  Assign
                    { place = Own value; value = operation F.Divide Float [ change; Dt ]; span };
                ];
              else_ = [];
              predicted = false;
              span;
            };
          Assign { place = Own input; value = kept; span };
        ]
    | _ -> broken "a derivative of other than one signal"
  in
  add draft (work ~operands:[ atom; atom ] span statements)

(* What advances at the start of a step, before anything is computed. *)
let advance ~limited (eq : F.equation) (memory : State.memory) =
  match memory with
  | Elapsed { time; advances; restart = Bool false; unit = _ } ->
      let value =
        if limited then Ir.Soon (Field time, Dt_nanoseconds) else Later (Field time, Dt_nanoseconds)
      in
      if advances then Some (Ir.Assign { place = Own time; value; span = eq.span }) else None
  | Integrated { value; input } ->
      let step = operation F.Multiply Float [ Dt; input ] in
      let sum = operation F.Add Float [ Field value; step ] in
      Some (Assign { place = Own value; value = sum; span = eq.span })
  | Ticked { time; period } ->
      (* It was less than the period, and dt is at most 10^18. *)
      let in_range = match period with Float x -> x <= 8e18 | Signal _ | Bool _ | Int _ -> false in
      let value =
        if in_range then Ir.Soon (Field time, Dt_nanoseconds) else Later (Field time, Dt_nanoseconds)
      in
      Some (Assign { place = Own time; value; span = eq.span })
  | Elapsed _ | Delayed _ | Differentiated _ | Kept _ -> None

(* Where it does not start again, it goes on. *)
let start_again draft time restart span =
  let statements restart =
    let else_ = Ir.Later (Field time, Dt_nanoseconds) in
    let value = Ir.Select { condition = one restart; then_ = Zero_time; else_ } in
    [ Ir.Assign { place = Own time; value; span } ]
  in
  add draft (work ~operands:[ restart ] span statements)

(* The rest is kept with the other state, last: only then has all else read what
   is left of it. What counts nanoseconds is never in a variable; it has no type
   in Flow. *)
let tick context draft (s : F.signal) time period span =
  let internal () =
    context.fresh <- context.fresh + 1;
    { s with id = context.fresh; name = ""; ty = F.Float }
  in
  let before = internal () and rest = internal () and next = internal () in
  let computed signal ?choice operands build =
    add draft (Computed { signal; operands; build; choice; weight = 2; span })
  in
  let on_period build = function
    | [ time; period ] -> build time period
    | _ -> broken "a period without a time"
  in
  leaf draft before (Field time);
  computed s [ Signal before; period ] (on_period (fun time period -> Ir.Reached { time; period }));
  computed rest [ Signal before; period ] (on_period (fun time period -> Ir.Rest { time; period }));
  computed next ~choice:(Signal s, Signal rest, Signal before) [ Signal s; Signal rest; Signal before ]
    (function
    | [ condition; then_; else_ ] -> Select { condition; then_; else_ }
    | _ -> broken "a choice with a wrong number of operands");
  draft.states <- (time, Signal next, Some before, span) :: draft.states

let step_equation context draft state (eq : F.equation) =
  let s = eq.defines in
  match State.memory state s with
  | None -> add_computed draft eq
  | Some (Kept field | Delayed field) -> leaf draft s (Field field)
  | Some (Elapsed { time; unit; restart; advances }) ->
      (match resolve draft restart with
      | Bool false -> ()
      | restart -> if advances then start_again draft time restart eq.span);
      let build _ : Ir.expr =
        match unit with
        | Seconds -> Seconds (Field time)
        | Nanoseconds -> In_nanoseconds (Field time)
      in
      add draft
        (Computed { signal = s; operands = []; build; choice = None; weight = 5; span = eq.span })
  | Some (Ticked { time; period }) -> tick context draft s time (resolve draft period) eq.span
  | Some (Integrated { value; _ }) -> leaf draft s (Field value)
  | Some (Differentiated { value; input }) ->
      leaf draft s (Field value);
      let argument =
        match eq.rhs with
        | Derivative atom -> resolve draft atom
        | _ -> broken "a derivative without argument"
      in
      differentiate draft ~value ~input argument eq.span

(* The state to write at the end of the step. *)
let next_state draft state (eq : F.equation) =
  match (State.memory state eq.defines, eq.rhs) with
  | Some (Delayed field), Delay { next; _ } ->
      Some (field, resolve draft next, Some eq.defines, eq.span)
  | Some (Integrated { input = Field input; _ }), Integral atom -> Some (input, resolve draft atom, None, eq.span)
  | _, _ -> None

let equations items =
  List.filter_map
    (function Flow.Schedule.Equation eq -> Some eq | Instance _ | Trial _ | Machine _ -> None)
    items

let modes_context context draft state : Modes.context =
  match State.machine state with
  | Some kept ->
      {
        program = context.program;
        callee = callee context;
        kept;
        resolve = resolve draft;
      }
  | None -> broken "a machine without state"

let output_span (node : F.node) (atom : F.atom) =
  match atom with Signal s -> s.span | Bool _ | Int _ | Float _ -> node.span

let step_body context state (node : F.node) ~limited ~is_root (statics : Statics.t) =
  let d = draft () in
  let parameter (s : F.signal) = leaf d s (Variable (variable s)) in
  List.iter parameter node.statics;
  List.iter parameter node.inputs;
  let kept (s : F.signal) =
    match State.memory state s with
    | Some (Kept field) -> leaf d s (Field field)
    | Some _ | None -> ()
  in
  List.iter kept statics.kept;
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> step_equation context d state eq
      | Instance i -> add d (call context (resolve d) i (State.instance state i))
      | Trial (i, trial) -> add d (try_out context (resolve d) i trial (State.instance state i))
      | Machine m -> add d (Modes.step (modes_context context d state) m))
    statics.in_step;
  let equations = equations statics.in_step in
  let advances =
    List.filter_map
      (fun (eq : F.equation) -> Option.bind (State.memory state eq.defines) (advance ~limited eq))
      equations
  in
  let for_transitions = List.map (fun s -> F.Signal s) (Modes.results_for_transitions node) in
  let outputs =
    let own = List.rev_map (fun (_, atom) -> resolve d atom) node.outputs in
    List.rev_append own (List.map (resolve d) for_transitions)
  in
  let returned, results =
    match outputs with
    | [ atom ] when not is_root -> (Some (atom, output_span node atom), [])
    | atoms -> (None, List.mapi (fun k atom -> (Ir.Result k, atom, output_span node atom)) atoms)
  in
  let body =
    Placement.statements
      {
        leaves = d.leaves;
        items = Array.of_list (List.rev d.items);
        results;
        states = List.rev_append d.states (List.filter_map (next_state d state) equations);
        returned;
        feedback = Feedback.of_node node;
      }
  in
  List.rev_append (List.rev advances) body

(* What reset does for one item; it comes after all static values. *)
let reset_effects context draft state (item : Flow.Schedule.item) =
  let assign field value span = Ir.Assign { place = Own field; value; span } in
  let constant span fields = work span (fun _ -> List.map (fun (f, e) -> assign f e span) fields) in
  let keep span (s : F.signal) =
    match State.memory state s with
    | Some (Kept field) ->
        [ work ~operands:[ resolve draft (F.Signal s) ] span (fun e -> [ assign field (one e) span ]) ]
    | Some _ | None -> []
  in
  match item with
  | Equation eq -> (
      let span = eq.span in
      match (State.memory state eq.defines, eq.rhs) with
      | Some (Delayed field), Delay { init; _ } ->
          let operands = [ resolve draft init ] in
          [ work ~operands span (fun e -> [ assign field (one e) span ]) ]
      | Some (Elapsed { advances = false; _ }), _ -> []
      | Some (Elapsed { time; _ } | Ticked { time; _ }), _ -> [ constant span [ (time, Zero_time) ] ]
      | Some (Integrated { value; input = Field input } | Differentiated { value; input }), _ ->
          [ constant span [ (value, Float 0.); (input, Float 0.) ] ]
      | Some (Integrated { value; _ }), _ -> [ constant span [ (value, Float 0.) ] ]
      | _, _ -> keep span eq.defines)
  | Instance i -> (
      match State.instance state i with
      | None -> List.concat_map (keep i.span) i.outputs
      | Some field ->
          let node = callee context i.node in
          let operands = List.map (resolve draft) (arguments context i node.reset) in
          let reset arguments =
            [ Ir.Reset { node = i.node; state = field; arguments; span = i.span } ]
          in
          [ work ~operands i.span reset ])
  | Trial _ -> []
  | Machine m -> [ Modes.start (modes_context context draft state) m ]

let reset_body context state (node : F.node) (statics : Statics.t) =
  let d = draft () in
  List.iter (fun (s : F.signal) -> leaf d s (Variable (variable s))) node.statics;
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> add_computed d eq
      | Instance i -> add d (call context (resolve d) i None)
      | Trial _ | Machine _ -> broken "a machine known at the start")
    statics.at_reset;
  let effects item = List.iter (add d) (reset_effects context d state item) in
  List.iter effects statics.in_step;
  List.iter effects statics.at_reset;
  Placement.statements
    {
      leaves = d.leaves;
      items = Array.of_list (List.rev d.items);
      results = [];
      states = [];
      returned = None;
      feedback = Feedback.none;
    }

let parameters reads signals = Reads.parameters reads (Long_list.map variable signals)

let rec alignment context (content : Ir.content) =
  match content with
  | Value ty -> Layout.alignment context.program.real context.program.sums ty
  | Running_mode -> 1
  | Component _ -> Layout.largest_alignment
  | Modes modes ->
      let of_mode largest (mode : Ir.mode) =
        List.fold_left
          (fun largest (field : Ir.field) -> max largest (alignment context field.content))
          largest (State.fields_of_mode mode)
      in
      List.fold_left of_mode 1 modes
  | State_of k | States_of { node = k; _ } -> (
      match (callee context k).state with
      | first :: _ -> alignment context first.content
      | [] -> 1)

let stepped body (modes : Ir.mode list) =
  let nodes = Int_table.create 8 in
  Walk.statements
    (function
      | Step { node; _ } | Loop { node; _ } -> Int_table.replace nodes node ()
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Await _ | Run _ | Return _ -> ())
    body;
  List.iter (fun (mode : Ir.mode) -> Int_table.replace nodes mode.node ()) modes;
  nodes

(* Whether the dt of the first instant shows in what a node computes: an
   integral multiplies it by 0, but a derivative and a time do not. *)
let sees_first_dt context state (statics : Statics.t) stepped =
  let own (eq : F.equation) =
    match State.memory state eq.defines with
    | Some (Elapsed _ | Ticked _ | Differentiated _) -> true
    | Some (Integrated { input = Field _; _ } | Delayed _ | Kept _) | None -> false
    | Some (Integrated _) -> true
  in
  List.exists own (equations statics.in_step)
  || Int_table.fold (fun k () any -> any || context.sees_first_dt.(k)) stepped false

(* The number of a mode may be one byte. *)
let most_modes_and_none = 255

(* A machine of the root's that enters its first mode in the first step, where
   that is short: its number then tells that there was no step before. *)
let started_by_step first (body : Ir.statement list) (reset : Ir.statement list) =
  let run (s : Ir.statement) : Ir.statement =
    match s with
    | Run run when Direct.is_direct run && Option.is_none run.active -> Run { run with start = first }
    | s -> s
  in
  let body' = List.map run body in
  if List.for_all2 ( == ) body body' then None
  else
    let await (s : Ir.statement) : Ir.statement =
      match s with Enter { span; _ } -> Await { span } | s -> s
    in
    Some (body', List.map await reset)

(* The calls of the user's C, from the leaves and back, are for {!Cgen}. *)
let foreign_node context k (node : F.node) (foreign : F.foreign) : Ir.node =
  let stateful = node.kind = Signal_function in
  context.sees_first_dt.(k) <- stateful;
  let state : Ir.field =
    {
      id = 0;
      name = "state";
      content = Component foreign.import.symbol;
      purpose = "of the user's C";
      span = node.span;
    }
  in
  {
    name = node.name;
    origin = node.origin;
    file = node.file;
    span = node.span;
    state = (if stateful then [ state ] else []);
    modes = [];
    foreign = Some foreign;
    reset = { parameters = []; body = [] };
    step = { parameters = List.map variable node.inputs; body = [] };
    outputs = List.map (fun (name, atom) -> (name, atom_type atom)) node.outputs;
    seconds = stateful;
    nanoseconds = false;
    operations = 20;
  }

let rec node context k ~is_root =
  match context.program.nodes.(k) with
  | { foreign = Some foreign; _ } as node -> (foreign_node context k node foreign, Ir.Unseen)
  | { foreign = None; _ } -> own_node context k ~is_root

and own_node context k ~is_root =
  let node = context.program.nodes.(k) in
  let statics = context.statics.(k) in
  let statics_of k = List.map variable context.program.nodes.(k).statics in
  let state = State.of_node ~callee:(callee context) ~statics:statics_of statics in
  let body = step_body context state node ~limited:(context.is_limited k) ~is_root statics in
  let modes = Option.fold (State.machine state) ~none:[] ~some:(fun (m : State.machine) -> m.modes) in
  let stepped = stepped body modes in
  context.sees_first_dt.(k) <- sees_first_dt context state statics stepped;
  let reads = Reads.of_body body in
  let reset = reset_body context state node statics in
  let fields = State.fields state in
  let sees_first_dt = is_root && context.sees_first_dt.(k) in
  let first =
    match node.machine with
    | Some m when sees_first_dt && List.length modes > 1 && List.length modes <= most_modes_and_none ->
        Modes.first (modes_context context (draft ()) state) m
    | Some _ | None -> None
  in
  let started_by_step =
    if Option.is_some first then started_by_step first body reset else None
  in
  let body, reset = Option.value started_by_step ~default:(body, reset) in
  let marked =
    List.find_map
      (fun (eq : F.equation) ->
        match (eq.rhs, State.memory state eq.defines) with
        | Delay { init = Bool false; next = Bool true }, Some (Delayed field) -> Some field
        | _, _ -> None)
      (equations statics.in_step)
  in
  let mark =
    if sees_first_dt && Option.is_none started_by_step && Option.is_none marked then
      [ State.new_field state ~name:"started" (Value Bool) ~purpose:State.past_first node.span ]
    else []
  in
  let unmark (field : Ir.field) =
    Ir.Assign { place = Own field; value = Bool false; span = field.span }
  in
  let by_alignment (a : Ir.field) (b : Ir.field) =
    compare (alignment context b.content) (alignment context a.content)
  in
  let any property =
    Int_table.fold (fun k () any -> any || property (callee context k)) stepped false
  in
  let translated : Ir.node =
    {
      name = node.name;
      origin = node.origin;
      file = node.file;
      span = node.span;
      state = List.stable_sort by_alignment (fields @ mark);
      modes;
      foreign = None;
      reset =
        { parameters = parameters (Reads.of_body reset) node.statics; body = reset @ List.map unmark mark };
      step =
        {
          parameters =
            (if is_root then Long_list.map variable node.inputs
             else parameters reads (List.rev_append (List.rev node.statics) node.inputs));
          body;
        };
      outputs =
        (let for_transitions =
           List.map
             (fun (s : F.signal) -> (s.name, Layout.ty s.ty))
             (Modes.results_for_transitions node)
         in
         let own = List.rev_map (fun (name, atom) -> (name, atom_type atom)) node.outputs in
         List.rev_append own for_transitions);
      seconds = reads.seconds || any (fun (n : Ir.node) -> n.seconds);
      nanoseconds = reads.nanoseconds || any (fun (n : Ir.node) -> n.nanoseconds);
      operations = reads.operations;
    }
  in
  let first_instant : Ir.first_instant =
    match (mark, marked) with
    | field :: _, _ -> Marked_by { field; own = true }
    | [], _ when Option.is_some started_by_step -> Marked_by_mode
    | [], Some field when sees_first_dt -> Marked_by { field; own = false }
    | [], _ -> Unseen
  in
  (translated, first_instant)

let program (program : F.program) : Ir.program =
  let count = Array.length program.nodes in
  let context =
    {
      program;
      statics = Statics.program program;
      done_ = Array.make count None;
      sees_first_dt = Array.make count false;
      is_limited = Flow.Time_limit.is_limited program;
      fresh = Flow.Signals.next_id program;
    }
  in
  let first_instant = ref Ir.Unseen in
  for k = 0 to count - 1 do
    let translated, first = node context k ~is_root:(k = count - 1) in
    context.done_.(k) <- Some translated;
    first_instant := first
  done;
  {
    name = program.name;
    sums = program.sums;
    imports = program.imports;
    headers = program.headers;
    nodes = Array.init count (callee context);
    input = program.input;
    output = program.output;
    ends = program.ends;
    real = program.real;
    first_instant = !first_instant;
  }
