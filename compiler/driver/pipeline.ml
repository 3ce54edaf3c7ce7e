open Basis

let ( let* ) = Option.bind
let stage = Request.stage
let files = { Resolve.Files.on_disk with parsed = Prepared.Library.tree }

(* Imports ask for modules; the main one is read here too, to be looked at as parsed. *)
let parse (r : Request.t) sink sources =
  let asked = r.dump = Some Parse || r.stop_after = Some Parse in
  match if asked then Result.to_option (files.read r.file) else None with
  | Some text ->
      Source.add sources ~file:r.file text;
      let* parsed = Syntax.Parse.program sink ~file:r.file text in
      let lint = Syntax.Lint.program and print = Syntax.Print.program in
      Option.map ignore (stage r sink Parse ~lint ~print parsed)
  | None -> Some ()

let module_files ~library file =
  let modules =
    Resolve.Modules.load (Diagnostic.sink ()) ~files ~remember:(fun ~file:_ _ -> ()) ~library file
  in
  let path (m : Resolve.Modules.t) =
    if m.library then Filename.concat library (m.name ^ ".frob") else m.file
  in
  let from_library, own = List.partition (fun (m : Resolve.Modules.t) -> m.library) modules in
  (List.rev_map path own, List.rev_map path from_library)

type front = { resolved : Resolve.Ir.program; typed : Typing.Ir.program; core : Core.Ir.program }

let front (r : Request.t) sink sources =
  let own = Request.own_robot r in
  let* () = parse r sink sources in
  let* resolved =
    Resolve.Program.load sink ~files ~library:r.library r.file
      ~remember:(fun ~file text -> Source.add sources ~file text)
      ?also:(Option.bind own (fun robot -> robot.file))
  in
  let lint = Resolve.Lint.program and print = Resolve.Print.program in
  let* resolved = stage r sink Resolve ~lint ~print resolved in
  (* Nobody looks at a definition of the library that the program cannot come to. *)
  let keep = Typing.Side_by_side.needs @ Specialize.Context.known_by_name in
  let resolved = Resolve.Reachable.program ~keep resolved in
  let* typed = Typing.Of_resolved.program ~sources sink ~real:r.real resolved in
  Resolve.Unused.warn sink resolved;
  Typing.Senseless.warn sink resolved typed;
  Typing.Reach.warn sink resolved typed ~robot:(Option.map Robots.input r.robot);
  Option.iter (Robots.check_own sink typed) own;
  let* typed = stage r sink Types ~lint:Typing.Lint.program ~print:Typing.Print.program typed in
  let core = Core.Of_typed.program typed in
  let* core = stage r sink Core ~lint:Core.Lint.program ~print:Core.Print.program core in
  Some { resolved; typed; core }

let for_a_robot r { resolved; typed; core } entry : Robots.program =
  { typed; core; entry; signed = Typing.Entry.is_signed resolved entry; own = Request.own_robot r }

let lint_flow program =
  Flow.Lint.program program;
  Flow.Initialization.check program

(* [written]: the entry as the programmer knows it, before a robot closes it. *)
let specialized (r : Request.t) sink { typed; _ } ~(written : Typing.Ir.definition) (core, entry) =
  match Typing.Entry.refusal typed ~closed:(entry <> written.name) written with
  | Some refusal ->
      Core.Recursion.check sink core;
      Diagnostic.emit sink refusal;
      None
  | None ->
      let options = { Specialize.Context.default with limit = r.specialization_limit } in
      let name = C_file.name r.file in
      let* flow = Specialize.Of_core.program ~options sink ~name ~entry core in
      (* Before anything is moved: messages speak of equations as they were written. *)
      let entry = written.span in
      Flow.Causality.check sink ~entry flow;
      let* flow = if Diagnostic.has_errors sink then None else Some flow in
      let flow = Flow.Instantaneous_loops.program sink ~entry flow in
      stage r sink Specialize ~lint:lint_flow ~print:Flow.Print.program flow

(* A program for several robots is checked open, and what needs one with any that fits. *)
let check_entry (r : Request.t) sink front (written : Typing.Ir.definition) =
  let program = for_a_robot r front written.name in
  let sampled = Option.is_none r.robot && Robots.is_open program in
  match if sampled then Robots.sampled program else Robots.closed sink r.robot program with
  | Some closed -> ignore (specialized r sink front ~written closed)
  | None -> Core.Recursion.check sink front.core

let check sink sources r =
  let check front =
    match Typing.Entry.all front.typed with
    | [] -> Core.Recursion.check sink front.core
    | entries -> List.iter (check_entry r sink front) entries
  in
  Option.iter check (front r sink sources)

(* With what is to be seen beside its output. *)
let observed (r : Request.t) sink ~at core flow =
  match r.probes with
  | [] -> Some flow
  | names ->
      let* probes = Probes.named sink ~at core flow names in
      let shown, hidden = Probes.causal ~at flow probes in
      let* () = Probes.refuse_hidden sink ~at ~names hidden in
      let observed = Probe.Observed.program flow shown in
      if r.lint then lint_flow observed;
      Some observed

(* Where the entry is defined: a definition begins with its name. *)
let name_of (written : Typing.Ir.definition) =
  let { Span.file; start; _ } = written.span in
  Span.make ~file ~start ~stop:(Span.forward (String.length written.name.name) start)

(* A program is rejected for the same reasons whatever is to run it. *)
let plain sink sources (r : Request.t) =
  let* front = front r sink sources in
  let* written = Typing.Entry.find sink front.typed ~file:r.file r.entry in
  let* closed = Robots.closed sink r.robot (for_a_robot r front written.name) in
  let* flow = specialized r sink front ~written closed in
  Some (front, written, closed, flow)

let checked sink sources (r : Request.t) =
  let* _, written, closed, flow = plain sink sources r in
  let* flow = observed r sink ~at:(name_of written) (fst closed) flow in
  Some (written, closed, flow)

let probes sink sources r =
  let* front, written, (core, _), flow = plain sink sources r in
  let* all = Probes.all sink ~at:(name_of written) core flow in
  Some (Probes.list front.typed flow all)

let columns sink sources r =
  let* front, written, (core, _), flow = plain sink sources r in
  let* all = Probes.all sink ~at:(name_of written) core flow in
  Some (Columns.of_program front.typed written flow all)

let interpretable sink sources r =
  let* written, (core, entry), flow = checked sink sources r in
  let refusal = Interpreted.refusal ~at:written.span flow in
  Option.iter (Diagnostic.emit sink) refusal;
  if Option.is_none refusal then Some (core, entry) else None

let optimized r sink flow =
  let show = Request.each_pass r Flow.Print.program in
  let after (pass : Flow.Optimize.pass) = show ~name:pass.name ~reason:pass.reason in
  let optimized = Flow.Optimize.program ~after flow in
  let* optimized = stage r sink Passes ~lint:ignore ~print:(fun _ _ -> ()) optimized in
  stage r sink Flow ~lint:lint_flow ~print:Flow.Print.program optimized

let lowered r sink flow =
  let* flow = optimized r sink flow in
  let lint = Step.Lint.program and print = Step.Print.program in
  let show = Request.each_pass r print in
  let after (pass : Step.Passes.pass) = show ~name:pass.name ~reason:pass.reason in
  stage r sink Step ~lint ~print (Step.Passes.program ~after (Step.Of_flow.program flow))

let c (r : Request.t) sink step =
  let files = Cgen.Emit.program ?own:(Request.own_robot r) ~batch:r.batch step in
  stage r sink C ~lint:ignore ~print:Cgen.Emit.print files

let after_checks next sink sources r =
  Option.bind (checked sink sources r) (fun (_, _, flow) -> next r sink flow)

let flow sink = after_checks optimized sink
let step sink = after_checks lowered sink
let compile sink sources r = Option.bind (step sink sources r) (c r sink)

let for_both_engines sink sources r =
  let* _, (core, entry), flow = checked sink sources r in
  let* step = lowered r sink flow in
  (* The structs of a user's own robot are the program's then, and in no file of their own. *)
  Option.map (fun files -> (core, entry, files)) (c { r with robot = None } sink step)
