open Basis
open General

(* {1 Compiling} *)

let check_one general ?robot ~library file =
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  Pipeline.check sink sources (request general ?robot ~library file);
  print_diagnostics general.format sources sink;
  status sink

let check general files =
  let* resources = Resources.find () in
  let* robot = Robots.known general.robot in
  let statuses = List.map (check_one general ?robot ~library:resources.library) files in
  (* A rejected program outranks a missing file. *)
  if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses

(* Goes on with what a pipeline gives, or gives the status with which to end. *)
let accepted ?(quiet = false) pipeline general ?batch (resources : Resources.t) ~entry file
    continue =
  let* robot = Robots.known general.robot in
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  let request = request general ?robot ?batch ~entry ~library:resources.library file in
  let result = pipeline sink sources request in
  if Option.is_none result || not quiet then print_diagnostics general.format sources sink;
  match result with Some result -> continue request result | None -> status sink

(* Of the robot's types: those of any signal function from one to the other, such as
   [atRest] in its module. *)
let header_of (resources : Resources.t) (robot : Robots.t) =
  let sink = Diagnostic.sink () and sources = Source.create () and library = resources.library in
  let file = Option.value robot.file ~default:(Filename.concat library (robot.module_ ^ ".frob")) in
  let request = { (Request.make ~library file) with robot = Some robot; entry = "atRest" } in
  (Option.map (Cgen.Interface_header.text robot) (Pipeline.step sink sources request), sink,
    sources)

let robot_header resources (robot : Robots.t) =
  match header_of resources robot with
  | Some text, _, _ -> Ok (robot.header, text)
  | None, sink, sources ->
      Error
        (Printf.sprintf "%s cannot be compiled:\n%s"
          (Option.value robot.file ~default:robot.module_)
           (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink)))

let compiled ?quiet ?batch general resources ~entry file continue =
  let* () = C_file.check file in
  accepted ?quiet Pipeline.compile general ?batch resources ~entry file (fun request files ->
      match Request.own_robot request with
      | None -> continue files
      | Some robot ->
          let* header = robot_header resources robot in
          continue { files with robot_header = Some header })

(* As other compilers' [-o] takes a file. *)
let not_a_file ~folder file =
  let name = C_file.name file in
  let is_c = List.exists (Filename.check_suffix folder) [ ".c"; ".h" ] in
  if (not is_c) || (Sys.file_exists folder && Sys.is_directory folder) then Ok ()
  else
    Error
      (Printf.sprintf "-o takes the folder for %s.c and %s.h; %s is the name of a file (-o %s)" name
         name folder (Filename.dirname folder))

let compile general entry ~batch ~standalone folder file =
  let* () = not_a_file ~folder file in
  let* resources = Resources.find () in
  compiled ~batch general resources ~entry file (fun (files : Cgen.Emit.t) ->
      if general.dump <> None then Exit_status.ok
      else
        let path extension = Filename.concat folder (C_file.name file ^ extension) in
        let* files =
          if standalone then Standalone.files resources ~real:general.real files else Ok files
        in
        let robot_header =
          Option.map (fun (name, text) -> (Filename.concat folder name, text)) files.robot_header
        in
        let texts =
          [ (path ".h", files.header); (path ".c", files.source) ] @ Option.to_list robot_header
        in
        let output (path, _) = { Output.path; content = C; asked = "compile" } in
        let* () = Output.check ~reads:[ file ] (List.map output texts) in
        let* () = Output.folder folder in
        let* () = Output.write texts in
        Exit_status.ok)

(* {1 Reporting} *)

let report general ~entry ~states file =
  let* resources = Resources.find () in
  if states then
    accepted Pipeline.flow general resources ~entry file (fun _ program ->
        Format.printf "%a@?" Report.Diagram.print program;
        Exit_status.ok)
  else
  accepted Pipeline.watched general resources ~entry file (fun _ (program, watched) ->
      if general.dump = None then begin
        let bounds = Report.Bounds.of_program program in
        let judged program =
          Report.Judged.of_programs ~plain:bounds ~watched:(Report.Bounds.of_program program)
        in
        let judged = Option.map judged watched in
        match general.format with
        | Text -> print_string (Report.Text.to_string ?judged bounds)
        | Json -> print_endline (Report.For_tools.to_string ?judged bounds)
      end;
      Exit_status.ok)

(* {1 Running} *)

let rec all_exist = function
  | [] -> Ok ()
  | file :: _ when not (Sys.file_exists file) -> Error (Printf.sprintf "there is no file %s" file)
  | _ :: others -> all_exist others

let host_table ~entry (files : Cgen.Emit.t) =
  match files.host_table with
  | Some table -> Ok table
  | None ->
      Error
        (Printf.sprintf
           "`%s` takes or gives a value of a foreign type, and a table has no column for one; \
            compile it, and call it from C"
           entry)

let for_robot ~name ~sees (files : Cgen.Emit.t) =
  match (files.robot, files.cameras) with
  | None, _ ->
      Error (Printf.sprintf "%s is a program for no robot; `reactimateRobot` makes one" name)
  | Some _, _ when files.looks_for_tags ->
      Error
        (Printf.sprintf
           "%s looks for tags (`tags`); so far it is the simulator that finds them, where `frobc \
            run` runs it"
           name)
  | Some _, camera :: _ when not sees ->
      Error
        (Printf.sprintf
           "%s looks through a camera, `%s`; there are cameras in the simulator, and where Linux \
            runs, but not on a board"
           name camera)
  | Some _, _ -> Ok ()

let own_driver general =
  match Robots.own_of general.robot with
  | Some robot -> Printf.sprintf "frob_%s_driver" robot.name
  | None -> ""

(* The linker's words are of the machine's language; that it names the driver and no
   line of C is enough. *)
let is_driver_missing general ~sources text =
  let driver = own_driver general in
  let has word =
    let n = String.length word in
    let rec within i =
      i + n <= String.length text && (String.sub text i n = word || within (i + 1))
    in
    within 0
  in
  driver <> "" && has driver && not (List.exists has sources)

let about_driver general ~sources text =
  if is_driver_missing general ~sources text then
    Printf.sprintf
      "%s is a robot of your own: name the C files of its driver, which define `%s`, with `--with \
       FILE.c`"
      (Option.value general.robot ~default:"this") (own_driver general)
  else text

type linked = {
  machine : Toolchain.machine option;
  inputs : string list;
  includes : string list;
  generated : (string * string) list;
  sees : bool;
}

let built ?quiet ?batch general kind ~entry ~sources ~linked file continue =
  let* resources = Resources.find () in
  let* () = all_exist sources in
  compiled ?quiet ?batch general resources ~entry file (fun (files : Cgen.Emit.t) ->
      let name = C_file.name file in
      let linked = linked resources ~name in
      let* () =
        match (kind : Toolchain.kind) with
        | Executable -> for_robot ~name ~sees:linked.sees files
        | Shared_object -> Ok ()
      in
      let* host_table = host_table ~entry files in
      let* () = C_file.check ~beside_c:(sources <> []) file in
      let* () =
        Foreign_symbols.check ~calls:files.foreign.calls ~sources ~header:files.header
          ~folders:files.foreign.folders
      in
      let foreign =
        if files.foreign.folders = [] && files.foreign.calls = [] && sources = [] then None
        else Some { Toolchain.sources; folders = files.foreign.folders }
      in
      let* program =
        Toolchain.build ?machine:linked.machine kind ~headers:resources.headers
          ~inputs:linked.inputs ~includes:linked.includes ~foreign ~name
          ([
             (name ^ ".h", files.header); (name ^ ".c", files.source);
               (name ^ "_host.c", host_table);
           ]
          @ Option.to_list files.robot_header @ linked.generated)
        |> Result.map_error (about_driver general ~sources)
      in
      continue resources program)

(* The C files of a user's own robot may be given all at once, its driver's too. *)
let with_runtime general (resources : Resources.t) ~name:_ =
  let machine =
    Option.map
      (fun _ ->
        { (Toolchain.this_machine ()) with options = [ "-I"; resources.runtime_sources ] })
      (Robots.own_of general.robot)
  in
  { machine; inputs = [ resources.runtime ]; includes = []; generated = []; sees = true }

let missing_host host =
  wrong_use (Printf.sprintf "the host %s is missing: install frobc again" host)

let shared ?quiet ?batch ?(generated = []) ?(options = []) general ~entry ~sources file continue =
  let linked resources ~name =
    let linked = with_runtime general resources ~name in
    let machine = Option.value linked.machine ~default:(Toolchain.this_machine ()) in
    let machine = { machine with options = machine.options @ options } in
    { linked with machine = Some machine; generated }
  in
  built ?quiet ?batch general Shared_object ~entry ~sources ~linked file continue

(* The program as a shared object, and the host that is to run it. *)
let hosted general ~entry ~sources file ~host ~arguments =
  shared general ~entry ~sources file (fun resources program ->
      let host = host resources in
      match Process.hand_over host (arguments resources program) with
      | Ok status -> status
      | Error (Not_found _ | Failed _) -> missing_host host)

(* Instead of running a program. *)
let list_probes general ~entry file =
  let general = { general with probes = []; asserts = Off } in
  let* resources = Resources.find () in
  accepted Pipeline.probes general resources ~entry file (fun _ list ->
      print_string list;
      Exit_status.ok)

type engine = C | Interpreter

let as_output content asked path = { Output.path; content; asked }

let compiled_trace general ~params ~entry ~sources ~modes ~input ~output file =
  hosted general ~entry ~sources file
    ~host:(fun resources -> resources.Resources.trace_host)
    ~arguments:(fun _ program ->
      (if modes then [ "--modes" ] else [])
      @ assert_options general
      @ param_options params
      @ (program :: input :: Option.to_list output))

(* Speaks as the host of compiled programs does. *)
let interpreted_trace general ~params ~entry ~input ~output file =
  let* resources = Resources.find () in
  accepted Pipeline.interpretable general resources ~entry file (fun _ (core, entry, marks) ->
      let params = List.map (fun (p : Params.set) -> (p.param, p.value)) params in
      match Interpreted.trace core ~entry ~marks ~params ~input ~output with
      | Ok () -> Exit_status.ok
      | Error errors ->
          List.iter (Printf.eprintf "error: %s\n") errors;
          Exit_status.wrong_use)

let asks_for_list general = List.mem "list" general.probes

(* Of the trace's columns, where they are known. *)
let units_of_columns general (resources : Resources.t) ~entry file =
  let columns =
    match Robots.known general.robot with
    | Error _ -> None
    | Ok robot ->
        let request = request general ?robot ~entry ~library:resources.library file in
        Pipeline.columns (Diagnostic.sink ()) (Source.create ())
          { request with probes = [] }
  in
  let table = Hashtbl.create 64 in
  List.iter
    (fun (c : Columns.t) -> Hashtbl.replace table c.name c.unit_)
    (Option.value columns ~default:[]);
  fun name -> Option.value (Hashtbl.find_opt table name) ~default:""

let draw general ~entry ~trace ~picture file =
  let* resources = Resources.find () in
  let units = units_of_columns general resources ~entry file in
  let* drawn = Drawn.picture ~units trace in
  let* () = Output.write [ (picture, drawn) ] in
  Exit_status.ok

let trace general engine ~entry ~sources ~modes ~input ~output ~picture file =
  let run ~input ~output =
    let* resources = Resources.find () in
    with_params general resources ~entry file @@ fun params ->
    match engine with
    | C -> compiled_trace general ~params ~entry ~sources ~modes ~input ~output file
    | Interpreter when modes ->
        prerr_endline
          "error: modes are those of the compiled program: `--modes` needs `--engine c`";
        Exit_status.wrong_use
    | Interpreter when general.asserts = Stop ->
        wrong_use
          "assertions are judged in the compiled program: `--asserts=stop` needs `--engine c`"
    | Interpreter when List.exists (fun p -> p <> Drawing.probe) general.probes ->
        wrong_use "probes are put into the compiled program: `--probe` needs `--engine c`"
    | Interpreter -> interpreted_trace general ~params ~entry ~input ~output file
  in
  match input with
  | _ when asks_for_list general -> list_probes general ~entry file
  | None -> wrong_use "there is nothing to run on: `--input IN.csv` names a recording"
  | Some input -> (
      let outputs =
        List.map (as_output Table "--output") (Option.to_list output)
        @ List.map (as_output Picture "--picture") (Option.to_list picture)
      in
      let* () = Output.check ~reads:(input :: file :: sources) outputs in
      match picture with
      | None -> run ~input ~output
      | Some picture when not (Filename.check_suffix picture ".svg") ->
          wrong_use (Printf.sprintf "a trace is drawn as SVG: %s does not end in .svg" picture)
      | Some picture ->
          let trace =
            match output with
            | Some output -> output
            | None -> Filename.concat (Temporary.folder ()) "trace.csv"
          in
          let status = run ~input ~output:(Some trace) in
          if status = Exit_status.ok then draw general ~entry ~trace ~picture file else status)

type look = { browser : bool; control : bool }

type run = {
  world : string option;
  duration : float option;
  rate : float;
  seed : int;
  realtime : bool;
  record : string option;
  picture : string option;
  strict : bool;
  exit_when_done : bool;
  console : bool;
  look : look option;
}

let world_of given (resources : Resources.t) file =
  let beside = Filename.concat (Filename.dirname file) "world.toml" in
  match given with
  | Some world -> world
  | None when Sys.file_exists beside -> beside
  | None -> Filename.concat resources.worlds "room.toml"

(* Of a program that leaves its robot open, and of a world that does not, it is the
   world's. What is wrong with the world is told before anything that follows from it. *)
let robot_of_world (resources : Resources.t) world =
  match Process.output resources.simulator [ "--robot-of"; world ] with
  | Ok name -> Ok (match String.trim name with "" -> None | name -> Some name)
  | Error (Not_found host) ->
      Error (Printf.sprintf "the host %s is missing: install frobc again" host)
  | Error (Failed { errors; _ }) ->
    let text = String.trim errors and prefix = "error: " in
    let n = if String.starts_with ~prefix text then String.length prefix else 0 in
    Error (String.sub text n (String.length text - n))

let for_world general resources world =
  match general.robot with
  | Some _ -> Ok general
  | None -> Result.map (fun robot -> { general with robot }) (robot_of_world resources world)

(* {1 Showing} *)

(* In the place of a recording's name. *)
let live = "-"

(* A program with all its probes is large, and takes seconds to optimize: for a run of minutes
   it is not worth it. *)
let effort = function
  | None -> [ "-O0" ]
  | Some recording ->
      let size = (Unix.stat recording).st_size in
      [ (if size < 5_000_000 then "-O0" else "-O1") ]

(* With all that can be seen inside, and tables of where that is written and what it comes
   from. Of a program that is rejected, or has too much inside, nothing is known; the build
   that follows says why. *)
let with_all_probes general (resources : Resources.t) ~entry file =
  match Robots.known general.robot with
  | Error _ -> (general, [])
  | Ok robot -> (
      let request = request general ?robot ~entry ~library:resources.library file in
      match Pipeline.origins (Diagnostic.sink ()) (Source.create ()) request with
      | None -> (general, [])
      | Some (columns, origins) ->
          ( { general with probes = [ "all" ] },
            [
              ("frob_columns.c", Columns.text columns); ("frob_origins.c", Origins.text origins);
            ] ))

(* The commands by which a page has an edited program compiled, and run in the simulator; what
   the viewer adds are further options and the program's file. *)
let again general ~entry ~sources ~world ~seed ~recording =
  let same =
    [ "--entry"; entry ]
    @ List.concat_map (fun source -> [ "--with"; source ]) sources
    @ Option.fold ~none:[] ~some:(fun robot -> [ "--robot"; robot ]) general.robot
    @ match general.real with Real.Double -> [] | Single -> [ "--real"; "float" ]
  in
  ((Sys.executable_name :: "view" :: "--only-build" :: same)
  @ [ Option.value recording ~default:live ])
  @ Option.fold ~none:[] world ~some:(fun world ->
      ("--" :: Sys.executable_name :: "run" :: same)
      @ [ "--world"; world; "--seed"; string_of_int seed ])

(* What the viewer is started with: [recording] is [None] of a run that is recorded nowhere. *)
let viewer general (resources : Resources.t) ~entry ~sources ~options ~world ~seed ~recording
    ~program file =
  let own, library = Program_file.modules ~library:resources.library file in
  let each option files = List.concat_map (fun file -> [ option; file ]) files in
  (resources.viewer :: options)
  @ each "--world" (Option.to_list world)
  @ each "--source" own
  @ each "--library" library
  @ [ program; Option.value recording ~default:live ]
  @ again general ~entry ~sources ~world ~seed ~recording

let print_only browser = if browser then [] else [ "--print" ]

let shown ?(params = []) general ~entry ~sources look ~record ~world file continue =
  match look with
  | None -> continue []
  | Some { browser; control = _ } ->
      let* resources = Resources.find () in
      let* () = Program_file.check file in
      let general, generated = with_all_probes general resources ~entry file in
      shared general ~generated ~options:(effort None) ~entry ~sources file (fun _ program ->
          viewer general resources ~entry ~sources ~world ~seed:1
            ~options:(param_options params @ print_only browser) ~recording:record ~program file
          |> continue)

(* A recording has the verdicts on assertions that somebody watches. *)
let with_claims general =
  if general.asserts = Off || asks_for_list general then general
  else { general with probes = general.probes @ [ Probes.claims ] }

let run general ~entry ~sources run file =
  let general = with_claims general in
  let* resources = Resources.find () in
  let* () = Program_file.check file in
  let world = world_of run.world resources file in
  let* general = for_world general resources world in
  if asks_for_list general then list_probes general ~entry file
  else
  let outputs =
    List.map (as_output Table "--record") (Option.to_list run.record)
    @ List.map (as_output Picture "--picture") (Option.to_list run.picture)
  in
  let* () = Output.check ~reads:(file :: world :: sources) outputs in
  let option name value = match value with Some value -> [ name; value ] | None -> [] in
  let flag name value = if value then [ name ] else [] in
  with_params general resources ~entry file @@ fun params ->
  shown general ~params ~entry ~sources run.look ~record:run.record ~world:(Some world) file
  @@ fun viewer ->
  hosted general ~entry ~sources file
    ~host:(fun resources -> resources.Resources.simulator)
    ~arguments:(fun _ program ->
      [ program; "--world"; world ]
      @ option "--for" (Option.map (Printf.sprintf "%.9f") run.duration)
      @ [ "--rate"; Printf.sprintf "%.9g" run.rate ]
      @ [ "--seed"; string_of_int run.seed ]
      @ flag "--realtime" run.realtime
      @ option "--record" run.record
      @ option "--picture" run.picture
      @ param_options params
      @ flag "--exit-when-done" run.exit_when_done
      @ flag "--console" run.console
      @ flag "--strict" run.strict
      @ assert_options general
      @ if viewer = [] then [] else "--viewer" :: viewer)

type view = {
  recording : string option;
  browser : bool;
  port : int option;
  world : string option;
  seed : int;
  only_build : bool;
}

let is_port number = number >= 1 && number <= 65535

(* For the robot that a run would have been for. *)
let view general ~entry ~sources view file =
  let* () =
    match view.port with
    | Some port when not (is_port port) -> Error "--port takes a number from 1 to 65535"
    | Some _ | None -> Ok ()
  in
  let* resources = Resources.find () in
  let* () = Program_file.check file in
  let* () = all_exist (Option.to_list view.recording @ Option.to_list view.world) in
  let world = world_of view.world resources file in
  let* general = for_world general resources world in
  with_params general resources ~entry file @@ fun params ->
  let general, generated = with_all_probes general resources ~entry file in
  let options = effort view.recording in
  shared general ~generated ~options ~entry ~sources file (fun _ program ->
      if view.only_build then begin
        print_endline program;
        Exit_status.ok
      end
      else
        let options =
          param_options params @ print_only view.browser
          @ Option.fold ~none:[] ~some:(fun n -> [ "--port"; string_of_int n ]) view.port
        in
        let command =
          viewer general resources ~entry ~sources ~options ~world:(Some world) ~seed:view.seed
            ~recording:view.recording ~program file
        in
        match Process.become resources.viewer (List.tl command) with
        | Not_found _ | Failed _ -> missing_host resources.viewer)

(* {1 Explaining} *)

let header robot =
  let* resources = Resources.find () in
  let* robot = Robots.known (Some robot) in
  let text, sink, sources = header_of resources (Option.get robot) in
  match text with
  | Some text ->
      print_string text;
      Exit_status.ok
  | None when Diagnostic.has_errors sink ->
      prerr_string (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink));
      status sink
  | None -> Diagnostic.bug ~stage:"Driver" "no header for this robot"

let explain code =
  let is_number = code <> "" && String.for_all (fun c -> c >= '0' && c <= '9') code in
  let code = if is_number then Printf.sprintf "E%04d" (int_of_string code) else code in
  match Explain.find (String.uppercase_ascii code) with
  | Some page ->
      print_string page;
      Exit_status.ok
  | None ->
      let hint =
        match Suggest.closest (String.uppercase_ascii code) Explain.codes with
        | Some near -> Printf.sprintf "; did you mean `%s`?" near
        | None -> ""
      in
      wrong_use (Printf.sprintf "there is no diagnostic `%s`%s" code hint)
