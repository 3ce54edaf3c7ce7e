open Common_options
open Reporting

let host_table ~entry (files : Cgen.Emit.t) =
  match files.host_table with
  | Some table -> Ok table
  | None ->
      Error
        (Printf.sprintf
           "the input or output of `%s` has a foreign type, which frobc cannot read or print; \
            compile the program to C, and call it from your own C code"
           entry)

let for_robot ~name ~sees ?(ros2 = false) (files : Cgen.Emit.t) =
  match (files.robot, files.cameras, files.simulated) with
  | None, _, _ when Option.is_some files.node && ros2 -> Ok ()
  | None, _, _ when Option.is_some files.node ->
      Error
        (Printf.sprintf
           "%s is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run \
            --ros2`; `frobc trace` runs it on recorded input"
           name)
  | None, _, _ when ros2 ->
      Error
        (Printf.sprintf
           "%s is neither a robot program nor a node: use `reactimateRobot` for the robot `ros`, \
            or `node 50[Hz]` if its input and output are records of topics"
           name)
  | None, _, _ ->
      Error (Printf.sprintf "%s is not a robot program; use `reactimateRobot` to make one" name)
  | Some "ros", _, _ when not ros2 ->
      Error
        (Printf.sprintf
           "%s is compiled for `ros`, a robot that has no serial line: use `frobc run --ros2` or \
            `frobc build --ros2`"
           name)
  | Some _, _, sensor :: _ when not ros2 ->
      Error
        (Printf.sprintf
           "%s uses %s, but only the simulator has one; for your own robot, let the driver fill a \
            field of the input, and define an instance that reads this field"
           name sensor)
  | Some _, camera :: _, _ when not sees ->
      Error
        (Printf.sprintf
           "%s uses the camera `%s`, but cameras are available only in the simulator and on Linux \
            robots, not on boards"
           name camera)
  | Some _, _, _ -> Ok ()

let own_driver general =
  match Robots.own_of general.robot with
  | Some robot -> Printf.sprintf "frob_%s_driver" robot.name
  | None -> ""

(* The wording of the linker's message depends on the locale. If the message contains the driver's
   name but no name of a C file, it reports that the driver is missing. *)
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
      "%s is your own robot: add the C files of its driver, which define `%s`, with `--with FILE.c`"
      (Option.value general.robot ~default:"this")
      (own_driver general)
  else text

type linked = {
  machine : Toolchain.machine option;
  inputs : string list;
  includes : string list;
  generated : (string * string) list;
  sees : bool;
  ros2 : bool;
}

let built ?quiet ?batch general kind ~entry ~sources ~linked file continue =
  let* resources = Installation.find () in
  let* () = Program_file.all_exist sources in
  Compiled.to_c ?quiet ?batch general resources ~entry file (fun (files : Cgen.Emit.t) ->
      let name = C_file.name file in
      let linked = linked resources ~name in
      let* () =
        match (kind : Toolchain.kind) with
        | Executable -> for_robot ~name ~sees:linked.sees ~ros2:linked.ros2 files
        | Shared_object -> Ok ()
      in
      let* host_table = host_table ~entry files in
      let* () = C_file.check ~beside_c:(sources <> []) file in
      let* foreign = Foreign_files.checked ~name ~sources files in
      let* program =
        Toolchain.build ?machine:linked.machine kind ~headers:resources.headers
          ~inputs:linked.inputs ~includes:linked.includes ~foreign ~name
          ([
             (name ^ ".h", files.header); (name ^ ".c", files.source); (name ^ "_host.c", host_table);
           ]
          @ Option.to_list files.robot_header @ linked.generated)
        |> Result.map_error (about_driver general ~sources)
      in
      continue resources program)

(* The user may pass all C files of a user-defined robot, including its driver, which needs the
   runtime's headers. *)
let with_runtime general (resources : Resources.t) ~name:_ =
  let machine =
    Option.map
      (fun _ -> { (Toolchain.this_machine ()) with options = [ "-I"; resources.runtime_sources ] })
      (Robots.own_of general.robot)
  in
  {
    machine;
    inputs = [ resources.runtime ];
    includes = [];
    generated = [];
    sees = true;
    ros2 = false;
  }

let missing_host host = wrong_use (Printf.sprintf "the host %s is missing: reinstall frobc" host)

let shared ?quiet ?batch ?(generated = []) ?(options = []) general ~entry ~sources file continue =
  let linked resources ~name =
    let linked = with_runtime general resources ~name in
    let machine = Option.value linked.machine ~default:(Toolchain.this_machine ()) in
    let machine = { machine with options = machine.options @ options } in
    { linked with machine = Some machine; generated }
  in
  built ?quiet ?batch general Shared_object ~entry ~sources ~linked file continue

let hosted ?(goes_on = false) general ~entry ~sources file ~host ~arguments =
  shared general ~entry ~sources file (fun resources program ->
      let host = host resources in
      let arguments = arguments resources program in
      let ended =
        if goes_on then Process.hand_over host arguments else Error (Process.become host arguments)
      in
      match ended with Ok status -> status | Error (Not_found _ | Failed _) -> missing_host host)
