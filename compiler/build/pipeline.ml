open Basis
open Basis.Let_syntax.Option

let stage = Request.stage

(* {1 From text to Core} *)

type front = {
  resolved : Resolve.Ir.program;
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  margin : Span.t -> Core.Formula.t option;
}

type tree = Resolved of Resolve.Ir.program | Typed of Typing.Ir.program

(* Name resolution reads and parses the modules itself. If the request asks for it, this function
   parses the main module, but only to check and print its syntax tree. *)
let parse (r : Request.t) sink sources =
  let { Common_options.dump; stop_after; _ } = r.options in
  let is_asked = dump = Some Parse || stop_after = Some Parse in
  match if is_asked then Result.to_option (r.files.read r.file) else None with
  | Some text ->
      Source.add sources ~file:r.file text;
      let* parsed = Syntax.Parse.program (Advice.Of_syntax.into sink) ~file:r.file text in
      let lint = Syntax.Lint.program and print = Syntax.Print.program in
      Option.map ignore (stage r sink Parse ~lint ~print parsed)
  | None -> Some ()

let resolve (r : Request.t) sink sources =
  let also = Option.bind (Request.own_robot r) (fun robot -> robot.file) in
  let remember ~file text = Source.add sources ~file text in
  let* resolved =
    Resolve.Program.load (Advice.Of_resolve.into sink) ~files:r.files ~library:r.library r.file
      ~remember ?also ~given:r.settings
  in
  stage r sink Resolve ~lint:Resolve.Lint.program ~print:Resolve.Print.program resolved

(* Typing skips definitions of the library that the program cannot reach. *)
let reachable =
  Resolve.Reachable.program ~keep:(Typing.Side_by_side.needs @ Specialize.Context.known_by_name)

let elaborate r sink typed =
  let core = Core.Of_typed.program typed in
  let core, margin =
    if Request.measures_margins r then Core.Margin.program core else (core, fun _ -> None)
  in
  let* core = stage r sink Core ~lint:Core.Lint.program ~print:Core.Print.program core in
  Some (core, margin)

let front ?(seen = ignore) (r : Request.t) sink sources =
  let* () = parse r sink sources in
  let* resolved = resolve r sink sources in
  seen (Resolved resolved);
  let facts = Advice.Of_typing.into ~sources sink in
  let reached = reachable resolved in
  let* typed = Typing.Of_resolved.program ~sources facts ~real:r.options.real reached in
  seen (Typed typed);
  Warnings.emit r sink ~sources ~resolved:reached typed;
  Option.iter (Robots.check_own sink typed) (Request.own_robot r);
  Typing.Record_updates.check facts typed;
  let* typed = stage r sink Types ~lint:Typing.Lint.program ~print:Typing.Print.program typed in
  let* core, margin = elaborate r sink typed in
  Some { resolved; typed; core; margin }

(* {1 From Core to Flow} *)

let node sink front ~written (flow : Flow.Ir.program) =
  match flow.rate with
  | None -> Some None
  | Some rate ->
      let* node = Topics.of_program sink ~resolved:front.resolved front.typed written ~rate in
      Some (Some node)

let to_flow (r : Request.t) sink sources front ~(written : Typing.Ir.definition) (core, entry) =
  let facts = Advice.Of_typing.into sink and closed = entry <> written.name in
  if not (Typing.Entry.accepts facts front.typed ~closed written) then (
    Core.Recursion.check (Advice.Of_core.into sink) core;
    None)
  else
    let options = { Specialize.Context.default with limit = r.options.specialization_limit } in
    let name = C_file.name r.file in
    let* default = Params.defaults sink core in
    let* core = Operator.declared options sink front.typed ~name ~entry core in
    let* flow =
      Specialization.program r sink sources ~options ~default ~name ~entry ~written core
    in
    let* flow = stage r sink Specialize ~lint:Specialization.lint ~print:Flow.Print.program flow in
    let* _ = node sink front ~written flow in
    Some ((core, entry), flow)

(* {1 From Flow to C} *)

let optimize r sink flow =
  let after = Request.each_pass r Flow.Print.program in
  let optimized = Flow.Optimize.program ~after flow in
  let* optimized = stage r sink Passes ~lint:ignore ~print:(fun _ _ -> ()) optimized in
  stage r sink Flow ~lint:Specialization.lint ~print:Flow.Print.program optimized

let lower r sink flow =
  let print = Step.Print.program in
  let step = Step.Passes.program ~after:(Request.each_pass r print) (Step.Of_flow.program flow) in
  stage r sink Step ~lint:Step.Lint.program ~print step

let emit (r : Request.t) sink sources ~units ~named ?node step =
  let banner = if r.banner then Banner.lines r sources else [] in
  let own = Request.own_robot r in
  let files = Cgen.Emit.program ?own ~units ~named ~batch:r.batch ~banner ?node step in
  stage r sink C ~lint:ignore ~print:Cgen.Emit.print files
