open Basis

let ( let* ) = Option.bind
let stage = Request.stage

(* Imports ask for modules; the main one is read here too, to be looked at as parsed. *)
let parse (r : Request.t) sink sources =
  let asked = r.dump = Some Parse || r.stop_after = Some Parse in
  match if asked then Result.to_option (r.files.read r.file) else None with
  | Some text ->
      Source.add sources ~file:r.file text;
      let* parsed = Syntax.Parse.program sink ~file:r.file text in
      let lint = Syntax.Lint.program and print = Syntax.Print.program in
      Option.map ignore (stage r sink Parse ~lint ~print parsed)
  | None -> Some ()

type front = {
  resolved : Resolve.Ir.program;
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  margin : Span.t -> Core.Formula.t option;
}

type tree = Resolved of Resolve.Ir.program | Typed of Typing.Ir.program

let front ?(seen = ignore) (r : Request.t) sink sources =
  let own = Request.own_robot r in
  let* () = parse r sink sources in
  let* resolved =
    Resolve.Program.load sink ~files:r.files ~library:r.library r.file
      ~remember:(fun ~file text -> Source.add sources ~file text)
      ?also:(Option.bind own (fun robot -> robot.file))
      ~given:r.params
  in
  let lint = Resolve.Lint.program and print = Resolve.Print.program in
  let* resolved = stage r sink Resolve ~lint ~print resolved in
  seen (Resolved resolved);
  (* Nobody looks at a definition of the library that the program cannot come to. *)
  let keep = Typing.Side_by_side.needs @ Specialize.Context.known_by_name in
  let resolved = Resolve.Reachable.program ~keep resolved in
  let* typed = Typing.Of_resolved.program ~sources sink ~real:r.real resolved in
  seen (Typed typed);
  Resolve.Unused.warn sink resolved;
  Typing.Senseless.warn sink resolved typed;
  Typing.Reach.warn sink resolved typed ~robot:(Option.map Robots.input r.robot);
  Option.iter (Robots.check_own sink typed) own;
  let* typed = stage r sink Types ~lint:Typing.Lint.program ~print:Typing.Print.program typed in
  let core = Core.Of_typed.program typed in
  let core, margin = if r.margins then Core.Margin.program core else (core, fun _ -> None) in
  let* core = stage r sink Core ~lint:Core.Lint.program ~print:Core.Print.program core in
  Some { resolved; typed; core; margin }

let for_a_robot r { resolved; typed; core; _ } entry : Robots.program =
  { typed; core; entry; signed = Typing.Entry.is_signed resolved entry; own = Request.own_robot r }

(* The values of parameters, which only functions that come to an end can give. *)
let param_values sink (core : Core.Ir.program) values =
  if core.params = [] then values sink core
  else
    let own = Diagnostic.sink () in
    Core.Recursion.check own core;
    let found = if Diagnostic.has_errors own then None else values sink core in
    List.iter (Diagnostic.emit sink) (Diagnostic.all own);
    found

let lint program =
  Flow.Lint.program program;
  Flow.Initialization.check program

(* [written]: the entry as the programmer knows it, before a robot closes it. With the Core whose
   console has what the program asks for. *)
let specialized (r : Request.t) sink { typed; _ } ~(written : Typing.Ir.definition) (core, entry) =
  match Typing.Entry.refusal typed ~closed:(entry <> written.name) written with
  | Some refusal ->
      Core.Recursion.check sink core;
      Diagnostic.emit sink refusal;
      None
  | None ->
      let limit = r.specialization_limit in
      let name = C_file.name r.file in
      let* default = param_values sink core Params.defaults in
      let options = { Specialize.Context.default with limit } in
      let* core = Operator.declared options sink typed ~name ~entry core in
      let specialized marks =
        let options = { options with marks } in
        let* flow = Specialize.Of_core.program ~options ~default sink ~name ~entry core in
        (* Before anything is moved: messages speak of equations as they were written. *)
        let entry = written.span in
        Flow.Causality.check sink ~entry flow;
        let* flow = if Diagnostic.has_errors sink then None else Some flow in
        Some (Flow.Instantaneous_loops.program sink ~entry flow)
      in
      let* flow = specialized None in
      let* flow = Drawing.program r sink ~written ~specialized flow in
      let* flow = stage r sink Specialize ~lint ~print:Flow.Print.program flow in
      Some ((core, entry), flow)

(* A program for several robots is checked open, and what needs one with any that fits. *)
let check_entry (r : Request.t) sink front (written : Typing.Ir.definition) =
  let program = for_a_robot r front written.name in
  let sampled = Option.is_none r.robot && Robots.is_open program in
  match if sampled then Robots.sampled program else Robots.closed sink r.robot program with
  | Some closed ->
      let claims ((core, _), flow) =
        if Probe.Observed.has_claims flow then Probes.warn_of_claims sink written core flow
      in
      Option.iter claims (specialized r sink front ~written closed)
  | None -> Core.Recursion.check sink front.core

let check ?seen sink sources r =
  match front ?seen r sink sources with
  | Some front when Typing.Entry.all front.typed = [] ->
      Core.Recursion.check sink front.core;
      if not (Diagnostic.has_errors sink) then ignore (Params.defaults sink front.core)
  | Some front -> List.iter (check_entry r sink front) (Typing.Entry.all front.typed)
  | None -> ()

let partial sources (r : Request.t) =
  let sink = Diagnostic.sink () in
  Resolve.Program.load sink ~files:r.files ~library:r.library ~partial:true r.file
    ~remember:(fun ~file text -> Source.add sources ~file text)
  |> Option.map (fun resolved ->
         let keep = Typing.Side_by_side.needs @ Specialize.Context.known_by_name in
         ( resolved,
           lazy (Typing.Of_resolved.partial ~real:r.real (Resolve.Reachable.program ~keep resolved))
         ))

type t = {
  typed : Typing.Ir.program;
  written : Typing.Ir.definition;
  closed : Core.Ir.program * Core.Ir.Global.t;
  flow : Flow.Ir.program;
  margin : Span.t -> Core.Formula.t option;
}

let params sink sources r =
  let* front = front r sink sources in
  param_values sink front.core Params.given

let units_of_params sink sources r =
  let* front = front r sink sources in
  Some (List.map (fun (p : Core.Ir.param) -> (p.label, p.unit_)) front.core.params)

let checks sink sources r =
  let* front = front r sink sources in
  Core.Recursion.check sink front.core;
  if Diagnostic.has_errors sink then None
  else
    let checks = Checks.of_program sink front.core in
    if Diagnostic.has_errors sink then None else Some checks

let program sink sources (r : Request.t) =
  let* front = front r sink sources in
  let* written = Typing.Entry.find sink front.typed ~file:r.file r.entry in
  let* closed = Robots.closed sink r.robot (for_a_robot r front written.name) in
  let* closed, flow = specialized r sink front ~written closed in
  Some { typed = front.typed; written; closed; flow; margin = front.margin }
