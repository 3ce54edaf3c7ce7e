module F = Flow.Ir
open Basis

let broken what = Diagnostic.bug ~stage:"Step.Body" "%s" what

let modes_context (context : Calls.context) draft state : Modes.context =
  match State.machine state with
  | Some kept ->
      { program = context.program; callee = context.callee; kept; resolve = Draft.resolve draft }
  | None -> broken "a machine without state"

let output_span (node : F.node) (atom : F.atom) =
  match atom with Signal s -> s.span | Bool _ | Int _ | Float _ -> node.span

let step (context : Calls.context) state (node : F.node) ~limited ~is_root (statics : Statics.t) =
  let d = Draft.create () in
  let parameter (s : F.signal) = Draft.leaf d s (Variable (Modes.variable s)) in
  List.iter parameter node.statics;
  List.iter parameter node.inputs;
  let kept (s : F.signal) =
    match State.memory state s with
    | Some (Kept field) -> Draft.leaf d s (Field field)
    | Some _ | None -> ()
  in
  List.iter kept statics.kept;
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> Memory.step ~fresh:context.fresh d state eq
      | Instance i -> Draft.add d (Calls.call context (Draft.resolve d) i (State.instance state i))
      | Trial (i, trial) ->
          let field = State.instance state i in
          Draft.add d (Calls.try_out context (Draft.resolve d) i trial field)
      | Machine m -> Draft.add d (Modes.step (modes_context context d state) m))
    statics.in_step;
  let equations = Statics.equations_in_step statics in
  let advances = List.filter_map (Memory.advance ~limited state) equations in
  let for_transitions = List.map (fun s -> F.Signal s) (Modes.results_for_transitions node) in
  let outputs =
    let own = List.rev_map (fun (_, atom) -> Draft.resolve d atom) node.outputs in
    List.rev_append own (List.map (Draft.resolve d) for_transitions)
  in
  let delayed = List.filter_map (Memory.next d state) equations in
  let returned, results =
    match outputs with
    | [ atom ] when not is_root -> (Some (atom, output_span node atom), [])
    | atoms -> (None, List.mapi (fun k atom -> (Ir.Result k, atom, output_span node atom)) atoms)
  in
  let fragment = Draft.fragment d in
  (* The state of ticks is written last, because no other write shares its condition. *)
  let states = List.rev_append (List.rev delayed) fragment.states in
  ({ fragment with results; states; returned; advances }, Draft.resolve d)

(* The effects of one item in the reset. They follow the computation of all static values. *)
let reset_effects context draft state (item : Flow.Schedule.item) =
  match item with
  | Equation eq -> Memory.reset draft state eq
  | Instance i -> (
      match State.instance state i with
      | None -> List.concat_map (Memory.keep draft state i.span) i.outputs
      | Some field -> [ Calls.reset context (Draft.resolve draft) i field ])
  | Trial _ -> []
  | Machine m -> [ Modes.start (modes_context context draft state) m ]

let reset (context : Calls.context) state (node : F.node) (statics : Statics.t) =
  let d = Draft.create () in
  List.iter (fun (s : F.signal) -> Draft.leaf d s (Variable (Modes.variable s))) node.statics;
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> Draft.add_computed d eq
      | Instance i -> Draft.add d (Calls.call context (Draft.resolve d) i None)
      | Trial _ | Machine _ -> broken "a static machine or trial step")
    statics.at_reset;
  let effects item = List.iter (Draft.add d) (reset_effects context d state item) in
  List.iter effects statics.in_step;
  List.iter effects statics.at_reset;
  Draft.fragment d
