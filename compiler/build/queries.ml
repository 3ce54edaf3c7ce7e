open Basis
open Basis.Let_syntax.Option

type 'result t = Diagnostic.sink -> Source.t -> Request.t -> 'result

(* Runs stages. If the program needs more stack than is available, reports that and returns
   [None]. *)
let within_stack stages sink sources r =
  Stack_use.guarded sink sources r ~otherwise:None (fun () -> stages sink sources r)

(* {1 Checks} *)

let for_a_robot r { Pipeline.resolved; typed; core; _ } entry : Robots.program =
  { typed; core; entry; signed = Typing.Entry.is_signed resolved entry; own = Request.own_robot r }

(* Checks one entry. If neither the entry nor the request determines the robot, checks the entry for
   the first robot that fits, or without a robot if it cannot run on any. *)
let check_entry (r : Request.t) sink sources (front : Pipeline.front)
    (written : Typing.Ir.definition) =
  let program = for_a_robot r front written.name in
  let sampled = Option.is_none r.robot && Robots.is_open program in
  match if sampled then Robots.sampled program else Robots.closed sink r.robot program with
  | Some closed ->
      let claims ((core, _), flow) =
        if Probe.Observed.has_claims flow then Probes.warn_of_claims sink written core flow
      in
      Option.iter claims (Pipeline.to_flow r sink sources front ~written closed)
  | None -> Core.Recursion.check (Advice.Of_core.into sink) front.core

let check ?seen sink sources r =
  Stack_use.guarded sink sources r ~otherwise:() @@ fun () ->
  match Pipeline.front ?seen r sink sources with
  | Some front when Typing.Entry.all front.typed = [] ->
      Core.Recursion.check (Advice.Of_core.into sink) front.core;
      if not (Diagnostic.has_errors sink) then ignore (Params.defaults sink front.core)
  | Some front -> List.iter (check_entry r sink sources front) (Typing.Entry.all front.typed)
  | None -> ()

let partial sources (r : Request.t) =
  Resolve.Program.load (Facts.ignored ()) ~files:r.files ~library:r.library ~partial:true r.file
    ~remember:(fun ~file text -> Source.add sources ~file text)
  |> Option.map (fun resolved ->
         let typed () =
           Typing.Of_resolved.partial ~real:r.options.real (Pipeline.reachable resolved)
         in
         (resolved, Lazy.from_fun typed))

(* {1 What a module declares} *)

let of_front answer =
  within_stack (fun sink sources r ->
      Option.bind (Pipeline.front r sink sources) (fun (front : Pipeline.front) ->
          answer sink front.core))

let params sink = of_front Params.given sink

let units_of_params sink =
  let unit_of (p : Core.Ir.param) = (p.label, p.unit_) in
  of_front (fun _ core -> Some (List.map unit_of core.params)) sink

let checks sink =
  of_front
    (fun sink core ->
      Core.Recursion.check (Advice.Of_core.into sink) core;
      if Diagnostic.has_errors sink then None
      else
        let checks = Checks.of_program sink core in
        if Diagnostic.has_errors sink then None else Some checks)
    sink

(* {1 One entry} *)

type program = {
  resolved : Resolve.Ir.program;
  typed : Typing.Ir.program;
  written : Typing.Ir.definition;
  closed : Core.Ir.program * Core.Ir.Global.t;
  flow : Flow.Ir.program;
  margin : Span.t -> Core.Formula.t option;
}

let program sink sources (r : Request.t) =
  let* front = Pipeline.front r sink sources in
  let* written = Typing.Entry.find (Advice.Of_typing.into sink) front.typed ~file:r.file r.entry in
  let* closed = Robots.closed sink r.robot (for_a_robot r front written.name) in
  let* closed, flow = Pipeline.to_flow r sink sources front ~written closed in
  let { Pipeline.resolved; typed; margin; core = _ } = front in
  Some { resolved; typed; written; closed; flow; margin }

(* Adds the probes and, if [asserts] is true, the assertion data that hosts need. *)
let observed (r : Request.t) sink p ~asserts names =
  let* probes = Probes.named sink p.written (fst p.closed) p.flow names ~asserts in
  let causal, hidden = Probes.causal p.flow (List.map fst probes) in
  let* () = Probes.refuse_hidden sink p.written ~names hidden in
  let is_shown probe = List.assq probe probes in
  let flow = Probe.Observed.program p.flow causal in
  let claims =
    if asserts then Probe.Observed.claims ~shown:is_shown ~margin:p.margin causal else []
  in
  let flow = { flow with claims } in
  if r.options.lint then Specialization.lint flow;
  Some { p with flow }

let checked sink sources (r : Request.t) =
  let* program = program sink sources r in
  let has_claims = Probe.Observed.has_claims program.flow in
  let asserts = Request.judges r && has_claims in
  let is_there name = has_claims || not (List.mem name Probe.Selection.[ claims; margins ]) in
  match List.filter is_there (Drawing.others program.flow (Request.probes r)) with
  | [] when not asserts -> Some program
  | names -> observed r sink program ~asserts names

(* {1 Signals} *)

let of_probes show =
  within_stack (fun sink sources r ->
      let* p = program sink sources r in
      Option.map (show p) (Probes.all sink p.written (fst p.closed) p.flow))

let probes sink = of_probes (fun p all -> Drawing.row p.flow ^ Probes.list p.typed p.flow all) sink
let columns sink = of_probes (fun p -> Columns.of_program p.typed p.written p.flow) sink
let measures sink = of_probes (fun p -> Measures.of_judge p.typed (fst p.closed)) sink

let origins sink =
  let both p probes =
    let equations = Probe.Equations.of_program (fst p.closed) in
    ( Columns.of_program p.typed p.written p.flow probes,
      Probe.Origin.of_program equations p.flow probes )
  in
  of_probes both sink

(* {1 Programs for engines} *)

let lowered r sink flow = Option.bind (Pipeline.optimize r sink flow) (Pipeline.lower r sink)

let of_checked next =
  within_stack (fun sink sources r -> Option.bind (checked sink sources r) (next r sink sources))

let flow sink = of_checked (fun r sink _ p -> Pipeline.optimize r sink p.flow) sink
let step sink = of_checked (fun r sink _ p -> lowered r sink p.flow) sink

let emitted r sink sources p step =
  let units = Member_units.of_program ~resolved:p.resolved p.typed p.written in
  let named = Constant_names.of_program ~resolved:p.resolved p.typed in
  let node =
    Option.bind p.flow.rate (fun rate ->
        Topics.of_program sink ~resolved:p.resolved p.typed p.written ~rate)
  in
  let step =
    { step with Step.Ir.console = Console_places.at_uses p.written step.Step.Ir.console }
  in
  Pipeline.emit r sink sources ~units ~named ?node step

let compile sink =
  of_checked
    (fun r sink sources p -> Option.bind (lowered r sink p.flow) (emitted r sink sources p))
    sink

let interpretable sink =
  of_checked
    (fun r sink _ { written; closed = core, entry; flow; _ } ->
      let refusal = Interpreted.refusal ~at:written.span flow in
      Option.iter (Diagnostic.emit sink) refusal;
      let marks = if Drawing.is_shown r then flow.marks else 0 in
      if Option.is_none refusal then Some (core, entry, marks) else None)
    sink

let watched sink =
  Fun.flip within_stack sink @@ fun sink sources r ->
  let* plain = program sink sources r in
  let* step = lowered r sink plain.flow in
  if not (Probe.Observed.has_claims plain.flow) then Some (step, None)
  else
    let* claimed = observed r sink plain ~asserts:true [] in
    let* watched = lowered r sink claimed.flow in
    Some (step, Some watched)

let for_both_engines sink =
  of_checked
    (fun r sink sources ({ closed = core, entry; flow; _ } as program) ->
      let* step = lowered r sink flow in
      (* If the request names no user-defined robot, the program's header contains the robot's
         structs. *)
      let* files = emitted { r with robot = None } sink sources program step in
      Some (core, entry, files))
    sink
