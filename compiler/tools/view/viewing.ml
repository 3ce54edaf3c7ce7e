open Basis
open Common_options
open Reporting

type look = { browser : bool; control : bool }

(* The argument passed instead of a recording for a live run. *)
let live = "-"

(* Optimization level for the program. Optimizing a program with all its probes takes seconds, which
   is not worth it for a run of a few minutes. *)
let effort = function
  | None -> [ "-O0" ]
  | Some recording ->
      let size = (Unix.stat recording).st_size in
      [ (if size < 5_000_000 then "-O0" else "-O1") ]

(* Enables all probes, and generates tables of where they are in the source and where their values
   come from. If the program has errors or too many signals, changes nothing, because the build that
   follows reports the reason. *)
let with_all_probes general (resources : Resources.t) ~entry file =
  match Robots.known general.robot with
  | Error _ -> (general, [])
  | Ok robot -> (
      let request = Request.make ~options:general ?robot ~entry ~library:resources.library file in
      match Queries.origins (Diagnostic.sink ()) (Source.create ()) request with
      | None -> (general, [])
      | Some (columns, origins) ->
          ( { general with probes = [ "all" ]; asserts = Count },
            [ ("frob_columns.c", Columns.text columns); ("frob_origins.c", Origins.text origins) ]
          ))

(* The commands with which a page compiles an edited program and runs it in the simulator. The
   viewer appends options and the program's file. *)
let again general ~entry ~sources ~world ~seed ~recording =
  let same = [ "--entry"; entry ] @ to_repeat general ~sources in
  ((Sys.executable_name :: "view" :: "--only-build" :: same)
  @ [ Option.value recording ~default:live ])
  @ Option.fold ~none:[] world ~some:(fun world ->
        ("--" :: Sys.executable_name :: "run" :: same)
        @ [ "--world"; world; "--seed"; string_of_int seed ])

(* The command line of the viewer. [recording] is [None] for a run that is not recorded. *)
let viewer general (resources : Resources.t) ~entry ~sources ~options ~world ~seed ~recording
    ~program file =
  let own, library = Program_file.modules ~library:resources.library file in
  let each option files = List.concat_map (fun file -> [ option; file ]) files in
  (resources.viewer :: options)
  @ each "--world" (Option.to_list world)
  @ each "--source" own @ each "--library" library
  @ [ program; Option.value recording ~default:live ]
  @ again general ~entry ~sources ~world ~seed ~recording

let print_only browser = if browser then [] else [ "--print" ]

let shown ?(params = []) general ~entry ~sources look ~record ~world file continue =
  match look with
  | None -> continue []
  | Some { browser; control = _ } ->
      let* resources = Installation.find () in
      let* () = Program_file.check file in
      let general, generated = with_all_probes general resources ~entry file in
      Built.shared general ~generated ~options:(effort None) ~entry ~sources file (fun _ program ->
          viewer general resources ~entry ~sources ~world ~seed:1
            ~options:(Params.host_options params @ print_only browser)
            ~recording:record ~program file
          |> continue)

type view = {
  recording : string option;
  dialect : Interp.Dialect.t;
  browser : bool;
  port : int option;
  world : string option;
  compare : string option;
  seed : int;
  at : float option;
  only_build : bool;
  why_nan : bool;
}

let is_port number = number >= 1 && number <= 65535

(* Compiles the program for the robot that a run would use. *)
let view general ~entry ~sources view file =
  let* () =
    match view.port with
    | Some port when not (is_port port) -> Error "--port takes a number from 1 to 65535"
    | Some _ | None -> Ok ()
  in
  let* resources = Installation.find () in
  let* () = Program_file.check file in
  let general = Bag.for_its_robot general view.recording in
  let* recording =
    match view.recording with
    | None -> Ok None
    | Some path -> Result.map Option.some (Bag.recording ~program:file path)
  in
  let view = { view with recording } in
  let* () = Program_file.all_exist (Option.to_list view.recording @ Option.to_list view.compare) in
  let* world = Where.world_of view.world resources file in
  let* general = Where.for_world general resources world in
  Compiled.with_params general resources ~entry file @@ fun params ->
  let general, generated = with_all_probes general resources ~entry file in
  let options = effort view.recording in
  Built.shared general ~generated ~options ~entry ~sources file (fun _ program ->
      if view.only_build then (
        print_endline program;
        Exit_status.ok)
      else
        let options =
          Params.host_options params @ print_only view.browser
          @ Interp.Dialect.arguments view.dialect
          @ (if view.why_nan then [ "--why-nan" ] else [])
          @ Option.fold ~none:[] ~some:(fun other -> [ "--compare"; other ]) view.compare
          @ Option.fold ~none:[] ~some:(fun n -> [ "--port"; string_of_int n ]) view.port
          @ Option.fold ~none:[] ~some:(fun at -> [ "--at"; Printf.sprintf "%.9f" at ]) view.at
        in
        let command =
          viewer general resources ~entry ~sources ~options ~world:(Some world) ~seed:view.seed
            ~recording:view.recording ~program file
        in
        match Process.become resources.viewer (List.tl command) with
        | Not_found _ | Failed _ -> Built.missing_host resources.viewer)
