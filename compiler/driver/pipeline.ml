open Basis

let ( let* ) = Option.bind
let stage = Request.stage
let check sink sources r = Front_end.check sink sources r
let params = Front_end.params
let units_of_params = Front_end.units_of_params
let checks = Front_end.checks

(* With what is to be seen beside its output, and with what hosts are to know of its assertions. *)
let observed (r : Request.t) sink (p : Front_end.t) ~asserts names =
  let* probes = Probes.named sink p.written (fst p.closed) p.flow names ~asserts in
  let causal, hidden = Probes.causal p.written p.flow (List.map fst probes) in
  let* () = Probes.refuse_hidden sink p.written ~names hidden in
  let is_shown probe = List.assq probe probes in
  let flow = Probe.Observed.program p.flow causal in
  let claims =
    if asserts then Probe.Observed.claims ~shown:is_shown ~margin:p.margin causal else []
  in
  let flow = { flow with claims } in
  if r.lint then Front_end.lint flow;
  Some { p with flow }

let checked sink sources (r : Request.t) =
  let* program = Front_end.program sink sources r in
  let has_claims = Probe.Observed.has_claims program.flow in
  let asserts = r.asserts && has_claims in
  let is_there name = has_claims || not (List.mem name [ Probes.claims; Probes.margins ]) in
  match List.filter is_there (Drawing.others program.flow r.probes) with
  | [] when not asserts -> Some program
  | names -> observed r sink program ~asserts names

let all_probes show sink sources r =
  let* p = Front_end.program sink sources r in
  Option.map (show p) (Probes.all sink p.written (fst p.closed) p.flow)

let probes sink =
  all_probes (fun (p : Front_end.t) all -> Drawing.row p.flow ^ Probes.list p.typed p.flow all) sink

let columns sink =
  all_probes (fun (p : Front_end.t) -> Columns.of_program p.typed p.written p.flow) sink

let measures sink =
  let show (p : Front_end.t) = Measures.of_judge p.typed (fst p.closed) in
  all_probes show sink

let origins sink =
  let both (p : Front_end.t) probes =
    let equations = Probe.Equations.of_program (fst p.closed) in
    ( Columns.of_program p.typed p.written p.flow probes,
      Probe.Origin.of_program equations p.flow probes )
  in
  all_probes both sink

let interpretable sink sources r =
  let* { written; closed = core, entry; flow; _ } = checked sink sources r in
  let refusal = Interpreted.refusal ~at:written.span flow in
  Option.iter (Diagnostic.emit sink) refusal;
  let marks = if Drawing.is_seen r then flow.marks else 0 in
  if Option.is_none refusal then Some (core, entry, marks) else None

let optimized r sink flow =
  let after = Request.each_pass r Flow.Print.program in
  let optimized = Flow.Optimize.program ~after flow in
  let* optimized = stage r sink Passes ~lint:ignore ~print:(fun _ _ -> ()) optimized in
  stage r sink Flow ~lint:Front_end.lint ~print:Flow.Print.program optimized

let lowered r sink flow =
  let* flow = optimized r sink flow in
  let lint = Step.Lint.program and print = Step.Print.program in
  let after = Request.each_pass r print in
  stage r sink Step ~lint ~print (Step.Passes.program ~after (Step.Of_flow.program flow))

let c (r : Request.t) sink step =
  let files = Cgen.Emit.program ?own:(Request.own_robot r) ~batch:r.batch step in
  stage r sink C ~lint:ignore ~print:Cgen.Emit.print files

let after_checks next sink sources r =
  Option.bind (checked sink sources r) (fun (p : Front_end.t) -> next r sink p.flow)

let flow sink = after_checks optimized sink
let step sink = after_checks lowered sink

let watched sink sources (r : Request.t) =
  let* plain = Front_end.program sink sources r in
  let* step = lowered r sink plain.flow in
  if not (Probe.Observed.has_claims plain.flow) then Some (step, None)
  else
    let* claimed = observed r sink plain ~asserts:true [] in
    let* watched = lowered r sink claimed.flow in
    Some (step, Some watched)

let compile sink sources r = Option.bind (step sink sources r) (c r sink)

let for_both_engines sink sources r =
  let* { closed = core, entry; flow; _ } = checked sink sources r in
  let* step = lowered r sink flow in
  (* The structs of a user's own robot are the program's then, and in no file of their own. *)
  Option.map (fun files -> (core, entry, files)) (c { r with robot = None } sink step)
