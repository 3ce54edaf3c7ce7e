open Cmdliner
open Options
module Simulating = Tools.Simulating
module Tracing = Tools.Tracing
module Reporting = Build.Reporting

let trace =
  let input =
    let doc =
      "The recorded input: CSV with a header, which may be compressed ($(b,.csv.gz), \
       $(b,.csv.zst)). $(b,-) is standard input. Alternatively, a ROS 2 bag with the instants of a \
       node: a folder, or a $(b,.db3) or $(b,.mcap) file."
    in
    Arg.(value & opt (some string) None & info [ "input" ] ~docv:"IN.csv" ~doc)
  in
  let output =
    let doc = "Output file. The default is standard output." in
    Arg.(value & opt (some string) None & info [ "output" ] ~docv:"OUT.csv" ~doc)
  in
  let engine =
    let doc =
      "How to run the program: $(b,c) compiles it to C, $(b,interp) uses the reference \
       interpreter. The output is the same."
    in
    let engines = [ ("c", Tracing.C); ("interp", Tracing.Interpreter) ] in
    Arg.(value & opt (enum engines) Tracing.C & info [ "engine" ] ~docv:"ENGINE" ~doc)
  in
  let modes =
    let doc =
      "For each state machine of switches or tasks, add a column $(b,mode.NAME) that contains its \
       mode after each instant."
    in
    Arg.(value & flag & info [ "modes" ] ~doc)
  in
  let picture =
    let doc =
      "Draw the columns of the output, including inner signals, over time instead of printing them."
    in
    Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)
  in
  let run general dialect entry sources modes input output picture engine file =
    Tracing.trace general engine ~dialect ~entry ~sources ~modes ~input ~output ~picture file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "The input is CSV. Its first line names the columns: $(b,time) for the time of each \
         instant in seconds, and one column for each part of the program's input: $(b,in) for a \
         single value, $(b,in.1) and $(b,in.2) for a pair, $(b,in.heading) for the field of a \
         record. If the header is wrong, the error message shows the correct one.";
      `P
        "Numbers are in base units (m, s, rad); a Bool is $(b,true) or $(b,false); other data is \
         written as in a program, such as $(b,At 0.5). The cell of an event is empty when the \
         event does not occur. The output has the columns $(b,time) and $(b,out). If the input \
         also has $(b,out) columns, as in a recording made by $(b,frobc run), they are ignored.";
    ]
  in
  command "trace" ~man ~doc:"run a signal function on recorded input"
    Term.(
      const run
      $ judging (with_params probed)
      $ dialect $ entry $ sources $ modes $ input $ output $ picture $ engine $ file)

(* The options of `frobc run`. The options for hosts are in three groups: for all hosts, only for
   the simulator, and only for robots. *)

let for_hosts =
  Host_option.
    [
      time_span "for" ~docv:"TIME"
        ~doc:
          "How long to run, as in $(b,60s), $(b,500ms), $(b,2min) or $(b,1h). The default is one \
           minute in the simulator; on a robot, the run continues until you stop it.";
      one Arg.float ~print:(Printf.sprintf "%.9g") ~absent:"50." "rate" ~docv:"HZ"
        ~doc:"Steps of the controller per second.";
      flag "exit-when-done"
        ~doc:
          "Stop when the program's task ends, even if this is before the time given by $(b,--for).";
      flag "console" ~doc:"Pass typed keys to the program, one at each instant.";
    ]

let realtime = Host_option.flag "realtime" ~doc:"Run the simulator in real time, as on a robot."

let for_simulator =
  Host_option.
    [
      one Arg.int ~absent:"1" "seed" ~docv:"N"
        ~doc:"Seed of all noise: the same seed always leads to the same run.";
      flag "strict" ~doc:"End with status 4 when the robot hits something.";
    ]

let for_robots =
  Host_option.
    [
      time_span "patience" ~docv:"TIME"
        ~doc:
          "With $(b,--device) or $(b,--ros2): stop the robot if the newest reading is older than \
           this or if a step takes longer. The default is 200ms.";
      time_span "reconnect" ~docv:"TIME"
        ~doc:
          "With $(b,--device) or $(b,--ros2): how long to try to reconnect to a lost robot. The \
           default is 30s.";
      many "set" ~docv:"NAME=VALUE"
        ~doc:
          "With $(b,--device) or $(b,--ros2): change a setting of the robot's driver or of a \
           camera, as in $(b,camera.up=0.3). To list all settings, give an unknown name.";
      many "camera" ~docv:"SOURCE"
        ~doc:
          "With $(b,--device) or $(b,--ros2): the source of the camera's frames. This is a device \
           ($(b,/dev/video0)); an MJPEG stream ($(b,http://HOST:PORT/PATH)); a folder of pictures; \
           or a pipe or file of pictures (PPM, PGM, JPEG) or of raw frames, whose \
           $(b,camera.width) and $(b,camera.height) you set with $(b,--set). If the program has \
           several cameras, give $(b,LABEL=SOURCE) for each.";
      one Arg.int "priority" ~docv:"N"
        ~doc:"With $(b,--device) or $(b,--ros2): run with this real-time priority, 1 to 99.";
      flag "lock-memory"
        ~doc:"With $(b,--device) or $(b,--ros2): keep the program's memory from being swapped out.";
    ]

let world =
  some_string "world" ~docv:"WORLD.toml"
    ~doc:
      "The world to drive in: a file in the current folder or in the program's folder, or the name \
       of a world that comes with frobc. The default is $(b,world.toml) in the program's folder, \
       or the room that comes with frobc if there is no such file."

let record =
  some_string "record" ~docv:"LOG.csv"
    ~doc:
      "Write the input and output of every instant, in the format of $(b,frobc trace). The file is \
       compressed if its name ends in $(b,.gz) or $(b,.zst)."

let picture =
  some_string "picture" ~docv:"P.svg|P.png" ~doc:"Draw the world, the robot's path and the signals."

let device =
  some_string "device" ~docv:"DEV"
    ~doc:
      "Run on the robot at this serial port (a path, preferably in $(b,/dev/serial/by-id)) or this \
       address ($(b,tcp:HOST:PORT)) instead of in the simulator."

let ros2 =
  let doc =
    "Run as a ROS 2 node, for the robot $(b,ros), instead of in the simulator. Source the setup \
     script of ROS 2 first."
  in
  Arg.(value & flag & info [ "ros2" ] ~doc)

let ros_arguments =
  let doc =
    "With $(b,--ros2): arguments for ROS 2, up to $(b,--) or the end, as in $(b,--ros-args -r \
     odom:=base/odom -r __node:=follower)."
  in
  Arg.(value & opt_all string [] & info [ "ros-args" ] ~docv:"ARG" ~doc)

let lifecycle =
  let doc =
    "With $(b,--ros2): run as a managed node, which waits until other nodes configure and activate \
     it."
  in
  Arg.(value & flag & info [ "lifecycle" ] ~doc)

(* The real robot to run on, if any, with the option that chose it. *)
let way device ros2 lifecycle ros_arguments =
  let open Tools.Real_robot in
  match (device, ros2, ros_arguments) with
  | _, false, _ when lifecycle ->
      Error "--lifecycle only works with --ros2: add --ros2, or remove --lifecycle"
  | Some _, true, _ ->
      Error "a robot cannot be both on a serial line and in ROS 2: remove --device or --ros2"
  | _, false, _ :: _ -> Error "--ros-args only works with --ros2: add --ros2, or remove --ros-args"
  | _, true, arguments -> Ok (Some (Ros2 { lifecycle; arguments }, "--ros2"))
  | Some device, false, [] -> Ok (Some (Device device, "--device"))
  | None, false, [] -> Ok None

let run =
  let ( let* ) = Reporting.( let* ) in
  let make general entry sources device ros2 lifecycle ros_arguments world record picture look host
      realtime simulator robot file =
    let* look = look in
    let* way = way device ros2 lifecycle ros_arguments in
    match (way, robot) with
    | None, option :: _ ->
        let other =
          if option = "--set" then "; to set a parameter of the program, use --param" else ""
        in
        Reporting.wrong_use
          (Printf.sprintf "%s only works on a robot: use it with --device or --ros2%s" option other)
    | None, [] ->
        Simulating.run general ~entry ~sources
          { world; record; picture; look; host = host @ realtime @ simulator }
          file
    | Some (way, named), _ -> (
        let given name = Option.fold ~none:[] ~some:(fun _ -> [ name ]) in
        match given "--world" world @ given "--picture" picture @ simulator with
        | option :: _ ->
            Reporting.wrong_use
              (Printf.sprintf "%s only works in the simulator: remove it, or remove %s" option named)
        | [] ->
            Tools.Real_robot.run general ~entry ~sources
              { way; record; look; host = host @ robot }
              file)
  in
  command "run" ~doc:"run a robot program in the simulator or on a robot"
    Term.(
      const make
      $ judging (with_params probed)
      $ entry $ sources $ device $ ros2 $ lifecycle $ ros_arguments $ world $ record $ picture
      $ Viewing.look $ Host_option.all for_hosts $ realtime $ Host_option.all for_simulator
      $ Host_option.all for_robots $ file)

let demo =
  let make look =
    Reporting.(
      let* look = look in
      Tools.Demo.run { world = None; record = None; picture = None; look; host = [] })
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Creates the folder $(b,frob-demo) with a wall-following program, its tests and its world, \
         and runs the program for a minute in the simulator. If the folder exists, $(tname) uses \
         its files, so that you can change them and run $(tname) again.";
    ]
  in
  command "demo" ~man ~doc:"drive an example in the simulator" Term.(const make $ Viewing.look)
