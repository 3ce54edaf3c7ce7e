open Basis
open General

type look = { browser : bool; control : bool }

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
          ( { general with probes = [ "all" ]; asserts = Count },
            [ ("frob_columns.c", Columns.text columns); ("frob_origins.c", Origins.text origins) ]
          ))

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
  @ each "--source" own @ each "--library" library
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
      Built.shared general ~generated ~options:(effort None) ~entry ~sources file (fun _ program ->
          viewer general resources ~entry ~sources ~world ~seed:1
            ~options:(param_options params @ print_only browser)
            ~recording:record ~program file
          |> continue)

type view = {
  recording : string option;
  browser : bool;
  port : int option;
  world : string option;
  seed : int;
  at : float option;
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
  let* () = Program_file.all_exist (Option.to_list view.recording @ Option.to_list view.world) in
  let world = Where.world_of view.world resources file in
  let* general = Where.for_world general resources world in
  with_params general resources ~entry file @@ fun params ->
  let general, generated = with_all_probes general resources ~entry file in
  let options = effort view.recording in
  Built.shared general ~generated ~options ~entry ~sources file (fun _ program ->
      if view.only_build then (
        print_endline program;
        Exit_status.ok)
      else
        let options =
          param_options params @ print_only view.browser
          @ Option.fold ~none:[] ~some:(fun n -> [ "--port"; string_of_int n ]) view.port
          @ Option.fold ~none:[] ~some:(fun at -> [ "--at"; Printf.sprintf "%.9f" at ]) view.at
        in
        let command =
          viewer general resources ~entry ~sources ~options ~world:(Some world) ~seed:view.seed
            ~recording:view.recording ~program file
        in
        match Process.become resources.viewer (List.tl command) with
        | Not_found _ | Failed _ -> Built.missing_host resources.viewer)
