module F = Flow.Ir
open Basis

type context = {
  calls : Calls.context;
  statics : Statics.t array;
  sees_first_dt : bool array;  (** of the nodes already translated *)
  is_limited : int -> F.atom -> bool;  (** see {!Flow.Time_limit} *)
  may_end_early : bool array;
}

let variable = Modes.variable

let parameters reads signals = Reads.parameters reads (Long_list.map variable signals)

let rec alignment (calls : Calls.context) (content : Ir.content) =
  match content with
  | Value ty -> Layout.alignment calls.program.real calls.program.sums ty
  | Running_mode -> 1
  | Component _ -> Layout.largest_alignment
  | Modes modes ->
      let of_mode largest (mode : Ir.mode) =
        List.fold_left
          (fun largest (field : Ir.field) -> max largest (alignment calls field.content))
          largest (State.fields_of_mode mode)
      in
      List.fold_left of_mode 1 modes
  | State_of k | States_of { node = k; _ } -> (
      match (calls.callee k).state with
      | first :: _ -> alignment calls first.content
      | [] -> 1)

(* The nodes that this one steps, by its own code or as these modes. *)
let stepped body modes =
  let nodes = Int_table.create 8 in
  Walk.statements
    (function
      | Step { node; _ } | Loop { node; _ } -> Int_table.replace nodes node ()
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Run _ | Return _ -> ())
    body;
  List.iter (fun mode -> Int_table.replace nodes mode ()) modes;
  nodes

(* The modes that the step's dt comes to at the node's first instant: those that its
   machine starts with. What they lead to there is entered, with a dt of 0. *)
let first_modes (machine : F.machine option) =
  match machine with
  | None -> []
  | Some { active = Some _; modes; _ } -> modes
  | Some { active = None; modes; start; _ } ->
      List.map (fun (t : F.transition) -> List.nth modes t.target) start

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
    outputs = List.map (fun (name, atom) -> (name, Computation.atom_type atom)) node.outputs;
    for_transitions = 0;
    ends_early = None;
    seconds = stateful;
    nanoseconds = false;
    operations = 20;
  }

let own_node context k ~is_root =
  let calls = context.calls in
  let node = calls.program.nodes.(k) in
  let statics = context.statics.(k) in
  let statics_of k = List.map variable calls.program.nodes.(k).statics in
  let state = State.of_node ~callee:calls.callee ~statics:statics_of statics in
  let limited = context.is_limited k in
  let step, ends_early =
    Body.step calls state node ~limited ~is_root ~may_end_early:context.may_end_early.(k) statics
  in
  let modes = State.modes state in
  let any property stepped = Int_table.fold (fun k () any -> any || property k) stepped false in
  let callees_see =
    any (fun k -> context.sees_first_dt.(k)) (stepped step (first_modes node.machine))
  in
  context.sees_first_dt.(k) <- First_instant.shows_in state statics || callees_see;
  let all = stepped step (List.map (fun (mode : Ir.mode) -> mode.node) modes) in
  let reads = Reads.of_body step in
  let reset = Body.reset calls state node statics in
  let started, reset =
    if is_root && context.sees_first_dt.(k) then
      let mark, unmark = First_instant.mark state statics node.span in
      (Some mark, reset @ unmark)
    else (None, reset)
  in
  (* Floats without times between them are copied two at once. *)
  let is_time (field : Ir.field) =
    match field.content with Value Nanoseconds -> true | _ -> false
  in
  let by_alignment (a : Ir.field) (b : Ir.field) =
    compare
      (alignment calls b.content, is_time a)
      (alignment calls a.content, is_time b)
  in
  let reset : Ir.code =
    { parameters = parameters (Reads.of_body reset) node.statics; body = reset }
  in
  let step : Ir.code =
    {
      parameters =
        (if is_root then Long_list.map variable node.inputs
         else parameters reads (List.rev_append (List.rev node.statics) node.inputs));
      body = step;
    }
  in
  let for_transitions = Modes.results_for_transitions node in
  let translated : Ir.node =
    {
      name = node.name;
      origin = node.origin;
      file = node.file;
      span = node.span;
      state = List.stable_sort by_alignment (State.fields state);
      modes;
      foreign = None;
      reset;
      step;
      outputs =
        (let own =
           List.rev_map (fun (name, atom) -> (name, Computation.atom_type atom)) node.outputs
         in
         List.rev_append own
           (List.map (fun (s : F.signal) -> (s.name, Layout.ty s.ty)) for_transitions));
      for_transitions = List.length for_transitions;
      ends_early;
      seconds = reads.seconds || any (fun k -> (calls.callee k).seconds) all;
      nanoseconds = reads.nanoseconds || any (fun k -> (calls.callee k).nanoseconds) all;
      operations = reads.operations;
    }
  in
  (translated, started)

let node context k ~is_root =
  match context.calls.program.nodes.(k) with
  | { foreign = Some foreign; _ } as node -> (foreign_node context k node foreign, None)
  | { foreign = None; _ } -> own_node context k ~is_root

let program (program : F.program) : Ir.program =
  let count = Array.length program.nodes in
  let translated = Array.make count None in
  let callee k =
    match translated.(k) with
    | Some node -> node
    | None -> Diagnostic.bug ~stage:"Step.Of_flow" "a node is used before it is known"
  in
  let next_id = ref program.next_id in
  let fresh () =
    let id = !next_id in
    incr next_id;
    id
  in
  let context =
    {
      calls = { program; callee; fresh };
      statics = Statics.program program;
      sees_first_dt = Array.make count false;
      is_limited = Flow.Time_limit.is_limited program;
      may_end_early = Early_end.possible program;
    }
  in
  let started = ref None in
  for k = 0 to count - 1 do
    let node, first = node context k ~is_root:(k = count - 1) in
    translated.(k) <- Some node;
    started := first
  done;
  {
    name = program.name;
    sums = program.sums;
    imports = program.imports;
    headers = program.headers;
    nodes = Array.init count callee;
    input = program.input;
    output = program.output;
    ends = program.ends;
    probes = program.probes;
    real = program.real;
    started = !started;
  }
