open Basis

type options = {
  dump : Stage.t option;
  stop_after : Stage.t option;
  lint : bool;
  specialization_limit : int;
  real : Real.t;
}

let ( let* ) = Option.bind

(* What happens after each stage: its promises are checked (they hold for
   programs without errors) and its result shown, if asked for; with errors, or
   if it is the last one wanted, the pipeline ends here. *)
let stage options sink name ~lint ~print result =
  if options.lint && not (Diagnostic.has_errors sink) then lint result;
  if options.dump = Some name then Format.printf "%a@?" print result;
  if options.stop_after = Some name || Diagnostic.has_errors sink then None else Some result

let files = { Resolve.Files.on_disk with parsed = Prepared.Library.tree }

(* The resolver reads modules as imports ask for them. The main one is read
   here too if it is to be looked at as it was parsed. *)
let parse options sink sources file =
  if options.dump <> Some Parse && options.stop_after <> Some Parse then Some ()
  else
    match files.read file with
    | Error _ -> Some ()
    | Ok text ->
        Source.add sources ~file text;
        let* parsed = Syntax.Parse.program sink ~file text in
        Option.map ignore
          (stage options sink Parse ~lint:Syntax.Lint.program ~print:Syntax.Print.program parsed)

type front = {
  resolved : Resolve.Ir.program;
  typed : Typing.Ir.program;
  core : Core.Ir.program;
}

let own = function Some robot when Cgen.Robot.is_own robot -> Some robot | Some _ | None -> None

let front ?robot options sink sources ~library file =
  let own = own robot in
  let* () = parse options sink sources file in
  let* resolved =
    Resolve.Program.load sink ~files
      ~remember:(fun ~file text -> Source.add sources ~file text)
      ~library
      ?also:(Option.bind own (fun (robot : Cgen.Robot.t) -> robot.file))
      file
  in
  let* resolved =
    stage options sink Resolve ~lint:Resolve.Lint.program ~print:Resolve.Print.program resolved
  in
  (* Nobody looks at a definition of the library that the program cannot come to. *)
  let resolved = Resolve.Reachable.program ~keep:Specialize.Context.known_by_name resolved in
  let typed = Typing.Infer.program ~sources sink ~real:options.real resolved in
  (* Levels and patterns read types: after an error there they would only
     repeat it in other words. *)
  let* typed = if Diagnostic.has_errors sink then None else Some typed in
  Option.iter (Robots.check_own sink typed) own;
  let typed = Typing.Levels.program ~sources sink typed in
  Typing.Patterns.check sink typed;
  if not (Diagnostic.has_errors sink) then Resolve.Unused.warn sink resolved;
  let* typed =
    stage options sink Types ~lint:Typing.Lint.program ~print:Typing.Print.program typed
  in
  let* core =
    stage options sink Core ~lint:Core.Lint.program ~print:Core.Print.program
      (Core.Of_typed.program typed)
  in
  Some { resolved; typed; core }

(* Does the programmer say the type of this definition? *)
let signed (resolved : Resolve.Ir.program) name =
  let is_it (b : Resolve.Ir.binding) =
    match b.name with
    | Top (top, _) -> top = name && Option.is_some b.signature
    | Inner _ | Destructure _ -> false
  in
  List.exists
    (fun (g : Resolve.Ir.binding_group) -> List.exists is_it g.bindings)
    resolved.groups

let for_a_robot ?robot front entry : Robots.program =
  {
    typed = front.typed;
    core = front.core;
    entry;
    signed = signed front.resolved entry;
    own = own robot;
  }

let definition_of (core : Core.Ir.program) entry =
  List.find (fun (d : Core.Ir.definition) -> d.name = entry) core.definitions

let place core entry = (definition_of core entry).span

let lint_flow program =
  Flow.Lint.program program;
  Flow.Initialization.check program

let specialized options sink ~name ~entry core =
  let* flow =
    Specialize.Evaluate.program
      ~options:{ Specialize.Context.default with limit = options.specialization_limit }
      sink ~name ~entry core
  in
  (* Causality before anything is shared or moved: its messages speak of the
     equations as the programmer wrote them. *)
  let entry = place core entry in
  Flow.Causality.check sink ~entry flow;
  let flow =
    if Diagnostic.has_errors sink then flow else Flow.Instantaneous_loops.program sink ~entry flow
  in
  stage options sink Specialize ~lint:lint_flow ~print:Flow.Print.program flow

(* [written]: the entry as the programmer knows it, before a robot closes it. *)
let flow options sink front ~written ~name ~entry core =
  let definition =
    List.find (fun (d : Typing.Ir.definition) -> d.name = written) front.typed.definitions
  in
  let closed = Specialize.Evaluate.is_entry (definition_of core entry) in
  match Typing.Entry.refusal front.typed ~closed definition with
  | None -> specialized options sink ~name ~entry core
  | Some refusal ->
      Specialize.Recursion.check sink core;
      Diagnostic.emit sink refusal;
      None

let is_signal_function (definition : Core.Ir.definition) =
  match definition.ty with
  | Signal_function _ -> true
  | Data ({ module_ = "Prelude"; name = "Program" }, _) -> true
  | _ -> false

(* What a check looks into: the program, or, in a module without one, every
   signal function that could be an entry. A `main` that cannot be one is told so. *)
let entries (core : Core.Ir.program) =
  let is_own (d : Core.Ir.definition) = String.equal d.name.module_ core.main_module in
  let own = List.filter is_own core.definitions in
  match List.filter (fun (d : Core.Ir.definition) -> d.name.name = "main") own with
  | [] -> List.filter (fun d -> is_signal_function d && d.Core.Ir.parameters = []) own
  | main -> main

(* A program for several robots is checked as it stands, and in what needs a
   robot, such as its loops, with any that it runs on. *)
let check_entry ?robot options sink front ~file (d : Core.Ir.definition) =
  let program = for_a_robot ?robot front d.name in
  let closed =
    match robot with
    | None when Robots.is_open program -> Robots.sampled program
    | robot -> Robots.closed sink robot program
  in
  match closed with
  | Some (core, entry) -> ignore (flow options sink front ~written:d.name ~name:(C_file.name file) ~entry core)
  | None -> Specialize.Recursion.check sink front.core

let check ?robot options sink sources ~library file =
  match front ?robot options sink sources ~library file with
  | None -> ()
  | Some front -> (
      match entries front.core with
      | [] -> Specialize.Recursion.check sink front.core
      | entries -> List.iter (check_entry ?robot options sink front ~file) entries)

let no_entry = "E0501"

let find_entry sink (core : Core.Ir.program) ~file entry =
  let is_entry (d : Core.Ir.definition) =
    String.equal d.name.module_ core.main_module && String.equal d.name.name entry
  in
  match List.find_opt is_entry core.definitions with
  | Some definition -> Some definition.name
  | None ->
      let names =
        List.filter_map
          (fun (d : Core.Ir.definition) ->
            if String.equal d.name.module_ core.main_module then Some d.name.name else None)
          core.definitions
      in
      let diagnostic =
        Diagnostic.error ~code:no_entry ~at:(Span.start_of_file file)
          "there is no `%s` in this module to compile" entry
      in
      let diagnostic =
        match Suggest.closest entry names with
        | Some name -> Diagnostic.hint (Printf.sprintf "did you mean `--entry %s`?" name) diagnostic
        | None ->
            Diagnostic.hint
              "define `main`, or name a signal function of this module with `--entry NAME`"
              diagnostic
      in
      Diagnostic.emit sink diagnostic;
      None

let no_interpreter = "E0505"

(* The interpreter runs Frob only. *)
let refuse_foreign sink core ~entry (flow : Flow.Ir.program) =
  let refuse at what =
    Diagnostic.error ~code:no_interpreter ~at "the interpreter cannot run this program: %s" what
    |> Diagnostic.hint "run it with `--engine c`"
    |> Diagnostic.emit sink
  in
  let calls (node : Flow.Ir.node) = Option.is_some node.foreign in
  match List.find_opt calls (Array.to_list flow.nodes) with
  | Some node -> refuse node.span (Printf.sprintf "`%s` is in C" node.origin)
  | None ->
      if List.exists (Flow.Lasting.mentions_foreign flow.sums) [ flow.input; flow.output ] then
        refuse (place core entry) "it takes or gives a value of a foreign type"

(* A program is rejected for the same reasons whatever is to run it. *)
let checked ?robot options sink sources ~library ~entry file =
  let* front = front ?robot options sink sources ~library file in
  let* written = find_entry sink front.core ~file entry in
  let* core, entry = Robots.closed sink robot (for_a_robot ?robot front written) in
  let* flow = flow options sink front ~written ~name:(C_file.name file) ~entry core in
  Some (core, entry, flow)

let interpretable ?robot options sink sources ~library ~entry file =
  let* core, entry, flow = checked ?robot options sink sources ~library ~entry file in
  refuse_foreign sink core ~entry flow;
  if Diagnostic.has_errors sink then None else Some (core, entry)

let machine_of options sink flow =
  let* flow =
    stage options sink Flow ~lint:lint_flow ~print:Flow.Print.program
      (Flow.Optimize.program flow)
  in
  let* flow = stage options sink States ~lint:ignore ~print:Report.Diagram.print flow in
  stage options sink Machine ~lint:Machine.Lint.program ~print:Machine.Print.program
    (Machine.Of_flow.program flow)

let machine ?robot options sink sources ~library ~entry file =
  let* _, _, flow = checked ?robot options sink sources ~library ~entry file in
  machine_of options sink flow

(* Of the robot's types: those of any signal function from one to the other. *)
let robot_header sink sources ~library (robot : Cgen.Robot.t) =
  let options =
    { dump = None; stop_after = None; lint = false; specialization_limit = 10_000; real = Double }
  in
  let file =
    Option.value robot.file ~default:(Filename.concat library (robot.module_ ^ ".frob"))
  in
  let* machine = machine ~robot options sink sources ~library ~entry:"atRest" file in
  Some (Cgen.Interface_header.text robot machine)

let c ?own ?batch options sink machine =
  let print ppf (files : Cgen.Emit.t) =
    Format.pp_print_string ppf files.header;
    Format.pp_print_string ppf files.source
  in
  stage options sink C ~lint:ignore ~print (Cgen.Emit.program ?own ?batch machine)

let compile ?batch ?robot options sink sources ~library ~entry file =
  let* machine = machine ?robot options sink sources ~library ~entry file in
  let* files = c ?own:(own robot) ?batch options sink machine in
  match own robot with
  | None -> Some files
  | Some robot ->
      let* text = robot_header sink sources ~library robot in
      Some { files with robot_header = Some (robot.header, text) }

let for_both_engines ?robot options sink sources ~library ~entry file =
  let* core, entry, flow = checked ?robot options sink sources ~library ~entry file in
  let* machine = machine_of options sink flow in
  let* files = c options sink machine in
  Some (core, entry, files)
