let ( let* ) = Reporting.( let* )
let option name value = match value with Some value -> [ name; value ] | None -> []
let flag name value = if value then [ name ] else []

type serve = {
  world : string option;
  log : string option;
  link : string option;
  stamped : bool;
  ros_arguments : string list;
  host : string list;
}

let missing host = Printf.sprintf "the host %s is missing: reinstall frobc" host

let become host arguments =
  match Process.become host arguments with
  | Not_found _ | Failed _ -> Reporting.wrong_use (missing host)

(* The name of the robot for the host; for a user-defined robot, also the shared object
   compiled from its C files. *)
let served (resources : Resources.t) ~robot ~sources =
  let open Basis.Let_syntax.Result in
  let* known = Robots.known robot in
  match known with
  | Some own when Cgen.Robot.is_own own ->
      let* () = Program_file.all_exist sources in
      let* header = Compiled.robot_header resources own in
      let* object_ =
        Toolchain.build
          ~machine:
            { (Toolchain.this_machine ()) with options = [ "-I"; resources.runtime_sources ] }
          Shared_object ~headers:resources.headers ~inputs:[]
          ~foreign:
            (Some
               {
                 Toolchain.sources =
                   List.filter (fun file -> not (Own_headers.is_header file)) sources;
                 folders = List.map Filename.dirname sources;
                 allowed = sources;
               })
          ~name:own.name [ header ]
      in
      Ok (Some own.name, Some object_)
  | (Some _ | None) when sources <> [] ->
      Error "--with is for your own robot: use it with --robot FILE.frob"
  | Some _ | None -> Ok (robot, None)

let find_ros2 () =
  let open Basis.Let_syntax.Result in
  let* ros2 = Ros2.find () in
  Option.iter (fun text -> prerr_endline ("warning: " ^ text)) (Ros2.untried ());
  Ok ros2

(* The host's arguments for a ROS 2 robot: those that come first, and those that must come last. *)
let served_in_ros resources ~robot serve =
  let open Basis.Let_syntax.Result in
  match robot with
  | Some "ros" ->
      let* ros2 = find_ros2 () in
      let* node = Target.simulated_ros2 ros2 resources in
      Ok
        ( (("--node" :: [ node ]) @ if serve.stamped then [ "--stamped" ] else []),
          if serve.ros_arguments = [] then [] else "--ros-args" :: serve.ros_arguments )
  | (Some _ | None) when serve.stamped -> Error "--stamped is for the robot `ros`: add --robot ros"
  | (Some _ | None) when serve.ros_arguments <> [] ->
      Error "--ros-args is for the robot `ros`: add --robot ros"
  | Some _ | None -> Ok ([], [])

let serve ~robot ~sources serve =
  let* resources = Installation.find () in
  let* robot, own = served resources ~robot ~sources in
  let* world = Where.find resources [ Here ] (Option.value serve.world ~default:"room.toml") in
  let outputs =
    List.map (Output.asked Link "--link") (Option.to_list serve.link)
    @ List.map (Output.asked Log "--log") (Option.to_list serve.log)
  in
  let* () = Output.check ~reads:((world :: Option.to_list robot) @ sources) outputs in
  let* first, last = served_in_ros resources ~robot serve in
  become resources.server
    (("--world" :: world :: serve.host)
    @ option "--robot" robot @ option "--own" own @ option "--log" serve.log
    @ option "--link" serve.link @ first @ last)

type way = Device of string | Ros2 of { lifecycle : bool; arguments : string list }
type run = { way : way; record : string option; look : Viewing.look option; host : string list }

let executable (general : Common_options.t) target ~entry ~sources file continue =
  let own = Robots.own_of general.robot in
  Built.built general Executable ~entry ~sources
    ~linked:(Target.linked ?own target ~real:general.real) file (fun _ program -> continue program)

let this_machine = Option.get (Target.of_name "host")

(* {1 ROS 2} *)

(* The options for a program that is a ROS 2 node. *)
let as_node (general : Common_options.t) =
  match general.robot with
  | None | Some "ros" -> Ok { general with robot = Some "ros" }
  | Some other ->
      Error
        (Printf.sprintf "--ros2 is for the robot `ros`, not for `%s`: remove --robot"
           (Basis.Printable.name other))

(* A node publishes the program's drawing as markers. *)
let with_markers (general : Common_options.t) =
  { general with probes = general.probes @ [ Drawing.if_any ] }

let node general ~entry ~sources file continue =
  let* ros2 = find_ros2 () in
  Built.built general Executable ~entry ~sources ~linked:(Target.ros2 ros2) file (fun _ program ->
      continue program)

(* {1 Commands} *)

let executable_for way general ~entry ~sources file continue =
  match way with
  | Device _ -> executable general this_machine ~entry ~sources file continue
  | Ros2 _ -> node (with_markers general) ~entry ~sources file continue

(* The arguments that tell the host how to reach its robot, and those that must come last. *)
let leading = function
  | Device device -> ([ "--device"; device ], [])
  | Ros2 { lifecycle; arguments } ->
      ( (if lifecycle then [ "--lifecycle" ] else []),
        if arguments = [] then [] else ("--ros-args" :: arguments) @ [ "--" ] )

let for_way general = function Device _ -> Ok general | Ros2 _ -> as_node general

let run general ~entry ~sources run file =
  let* general = for_way (Probed.with_claims general) run.way in
  let outputs = List.map (Output.asked Table "--record") (Option.to_list run.record) in
  let* () = Output.check ~reads:(file :: sources) outputs in
  let* resources = Installation.find () in
  Compiled.with_params general resources ~entry file @@ fun params ->
  let control = match run.look with Some { control; _ } -> control | None -> false in
  Viewing.shown general ~params ~entry ~sources run.look ~record:run.record ~world:None file
  @@ fun viewer ->
  executable_for run.way general ~entry ~sources file (fun program ->
      let first, last = leading run.way in
      become program
        (first @ run.host @ option "--record" run.record @ Params.host_options params
        @ Common_options.assert_options general
        @ flag "--control" control @ last
        @ if viewer = [] then [] else "--viewer" :: viewer))

(* [-fno-semantic-interposition] allows direct calls within the object, because no other object
   replaces its functions. *)
let library general ~entry ~sources ~output file =
  let path = Option.value output ~default:(C_file.name file ^ ".so") in
  let asked = if output = None then "the library" else "-o" in
  let* () = Output.check ~reads:(file :: sources) [ Output.asked Program asked path ] in
  Built.shared ~batch:true ~options:[ "-fno-semantic-interposition" ] general ~entry ~sources file
    (fun _ library ->
      let* () = Output.copy library path in
      Exit_status.ok)

let build general ~entry ~sources ~target ~output file =
  match Target.of_name target with
  | None ->
      Reporting.wrong_use
        (Printf.sprintf
           "there is no target `%s`; the targets are %s; for Arduino, use `frobc export \
            --platformio`"
           target (String.concat ", " Target.names))
  | Some target ->
      let path = Option.value output ~default:(C_file.name file) in
      let asked = if output = None then "the program" else "-o" in
      let* () = Output.check ~reads:(file :: sources) [ Output.asked Program asked path ] in
      executable general target ~entry ~sources file (fun program ->
          let* () = Output.copy program path in
          match Target.size_tool target with
          | Some tool -> (
              match Process.hand_over tool [ path ] with Ok status -> status | Error _ -> 0)
          | None -> Exit_status.ok)

let build_node general ~entry ~sources ~output file =
  let* general = as_node general in
  let path = Option.value output ~default:(C_file.name file) in
  let asked = if output = None then "the program" else "-o" in
  let* () = Output.check ~reads:(file :: sources) [ Output.asked Program asked path ] in
  node general ~entry ~sources file (fun program ->
      let* () = Output.copy program path in
      Exit_status.ok)
