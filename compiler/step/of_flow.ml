module F = Flow.Ir
open Basis

type context = {
  calls : Calls.context;
  statics : Statics.t array;
  is_limited : int -> bool;  (** see {!Flow.Time_limit} *)
  may_end_early : bool array;
}

let variable = Modes.variable
let parameters reads signals = Reads.parameters reads (Long_list.map variable signals)

(* The nodes whose steps this node calls, in its own code or as modes. *)
let stepped body modes =
  let nodes = Int_table.create 8 in
  Walk.statements
    (function
      | Step { node; _ } | Loop { node; _ } -> Int_table.replace nodes node ()
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Run _ | Return _ -> ())
    body;
  List.iter (fun (mode : Ir.mode) -> Int_table.replace nodes mode.node ()) modes;
  nodes

(* {!Cgen} generates the call to the user's C code and the conversion of the leaves. *)
let foreign_node (node : F.node) (foreign : F.foreign) : Ir.node =
  let stateful = node.kind = Signal_function in
  let state : Ir.field =
    {
      id = 0;
      name = "state";
      content = Component foreign.import.symbol;
      bound = None;
      purpose = "state of the user's C component";
      origin = None;
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
    ends_early = None;
    seconds = stateful;
    nanoseconds = false;
    operations = 20;
  }

let own_node context k ~is_root : Ir.node =
  let calls = context.calls in
  let node = calls.program.nodes.(k) in
  let statics = context.statics.(k) in
  let static s = (variable s, State.origin s) in
  let statics_of k = List.map static calls.program.nodes.(k).statics in
  let state = State.of_node ~callee:calls.callee ~statics:statics_of statics in
  let limited = context.is_limited k in
  let step, resolve = Body.step calls state node ~limited ~is_root statics in
  let step =
    if context.may_end_early.(k) then Early_end.find ~fresh:calls.fresh ~resolve node step else step
  in
  let ends_early = Option.map (fun (e : Fragment.ending) -> e.told) step.ending in
  let step =
    Placement.statements (Feedback.of_node node) step
    |> Decided_conditions.statements calls.program.sums
  in
  let reset = Placement.statements Feedback.none (Body.reset calls state node statics) in
  let modes = State.modes state in
  let all = stepped step modes in
  let any property = Int_table.fold (fun k () any -> any || property (calls.callee k)) all false in
  let reads = Reads.of_body step in
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
  {
    name = node.name;
    origin = node.origin;
    file = node.file;
    span = node.span;
    state = State.fields state;
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
    ends_early;
    seconds = reads.seconds || any (fun callee -> callee.seconds);
    nanoseconds = reads.nanoseconds || any (fun callee -> callee.nanoseconds);
    operations = reads.operations;
  }

let node context k ~is_root =
  match context.calls.program.nodes.(k) with
  | { foreign = Some foreign; _ } as node -> foreign_node node foreign
  | { foreign = None; _ } -> own_node context k ~is_root

let program (program : F.program) : Ir.program =
  let next_id = ref program.next_id in
  let fresh () =
    let id = !next_id in
    incr next_id;
    id
  in
  let statics = Statics.program program in
  let is_limited = Flow.Time_limit.is_limited program in
  let may_end_early = Early_end.possible program in
  let root = Array.length program.nodes - 1 in
  let translated ~before k _ =
    let calls = { Calls.program; callee = before; fresh } in
    node { calls; statics; is_limited; may_end_early } k ~is_root:(k = root)
  in
  {
    name = program.name;
    sums = program.sums;
    imports = program.imports;
    headers = program.headers;
    nodes = In_order.map ~stage:"Step.Of_flow" translated program.nodes;
    input = program.input;
    console = program.console;
    output = program.output;
    ends = program.ends;
    probes = program.probes;
    claims = program.claims;
    marks = program.marks;
    params = program.params;
    real = program.real;
    started = None;
  }
