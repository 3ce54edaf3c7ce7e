open Cmdliner
open Options
module Simulating = Tools.Simulating
module Tracing = Tools.Tracing
module Viewing = Tools.Viewing
module Reporting = Build.Reporting

let trace =
  let input =
    let doc =
      "The recorded input: CSV with a header, which may be compressed ($(b,.csv.gz), \
       $(b,.csv.zst)). $(b,-) is standard input. Or a ROS 2 bag with the instants of a node: a \
       folder, or a file $(b,.db3) or $(b,.mcap)."
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
      "Add a column $(b,mode.NAME) for each state machine of switches or tasks, with the name of \
       its mode after the instant."
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
         event does not occur. The output has the columns $(b,time) and $(b,out). If the input has \
         $(b,out) columns too, like a recording of $(b,frobc run), they are ignored.";
    ]
  in
  command "trace" ~man ~doc:"run a signal function on recorded input"
    Term.(
      const run
      $ judging (with_params probed)
      $ dialect $ entry $ sources $ modes $ input $ output $ picture $ engine $ file)

(* Options of `frobc run`. Those of hosts are in three groups: for all hosts, for the simulator only,
   and for robots only. *)

let some_string name ~docv ~doc = Arg.(value & opt (some string) None & info [ name ] ~docv ~doc)

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
        ~doc:"Stop when the program's task ends, even if this is before the end of $(b,--for).";
      flag "console" ~doc:"Pass typed keys to the program, one at each instant.";
    ]

let realtime = Host_option.flag "realtime" ~doc:"Run the simulator in real time, like a robot."

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
           camera, as in $(b,camera.up=0.3). An unknown setting lists all settings.";
      many "camera" ~docv:"SOURCE"
        ~doc:
          "With $(b,--device) or $(b,--ros2): the source of the camera's frames. This is a device \
           ($(b,/dev/video0)); an MJPEG stream ($(b,http://HOST:PORT/PATH)); a folder of pictures; \
           or a pipe or file of pictures (PPM, PGM, JPEG) or of raw frames, whose \
           $(b,camera.width) and $(b,camera.height) you set by $(b,--set). If the program has \
           several cameras, give $(b,LABEL=SOURCE) for each.";
      one Arg.int "priority" ~docv:"N"
        ~doc:"With $(b,--device) or $(b,--ros2): run with this real-time priority, 1 to 99.";
      flag "lock-memory"
        ~doc:"With $(b,--device) or $(b,--ros2): keep the program's memory from being swapped out.";
    ]

(* An option of [frobc view] and [frobc run --view]. *)
let print_address =
  let doc = "Print the address of the page and do not open a browser." in
  Arg.(value & flag & info [ "print" ] ~doc)

(* `--view=print` is the older spelling of `--view --print`. *)
let look =
  let parts = [ ("print", `Print); ("control", `Control) ] in
  let doc =
    "Show the run live on a page with all signals, in real time; without $(b,--for), the run \
     continues until you stop it. Prints the address of the page, and opens a browser if there is \
     a desktop, unless you add $(b,--print). $(b,--view=control) lets viewers send events to a \
     real robot; otherwise they can only stop it."
  in
  let make view print =
    match view with
    | None when print -> Error "--print only works with --view: add it"
    | None -> Ok None
    | Some parts ->
        let browser = not (print || List.mem `Print parts) in
        Ok (Some { Viewing.browser; control = List.mem `Control parts })
  in
  Term.(
    const make
    $ Arg.(
        value
        & opt ~vopt:(Some []) (some (list (enum parts))) None
        & info [ "view" ] ~docv:"HOW" ~doc)
    $ print_address)

let run =
  let world =
    some_string "world" ~docv:"WORLD.toml"
      ~doc:
        "The world to drive in: a file in this folder or in the program's folder, or the name of a \
         world that comes with frobc. The default is $(b,world.toml) in the program's folder, or \
         the room that comes with frobc if there is no such file."
  in
  let record =
    some_string "record" ~docv:"LOG.csv"
      ~doc:
        "Write the input and output of every instant, in the format of $(b,frobc trace). The file \
         is compressed if its name ends in $(b,.gz) or $(b,.zst)."
  in
  let picture =
    some_string "picture" ~docv:"P.svg|P.png"
      ~doc:"Draw the world, the robot's path and the signals."
  in
  let device =
    some_string "device" ~docv:"DEV"
      ~doc:
        "Run on the robot at this serial port (a path, preferably in $(b,/dev/serial/by-id)) or \
         this address ($(b,tcp:HOST:PORT)) instead of in the simulator."
  in
  let ros2 =
    let doc =
      "Run as a ROS 2 node, for the robot $(b,ros), instead of in the simulator. Source the setup \
       script of ROS 2 first."
    in
    Arg.(value & flag & info [ "ros2" ] ~doc)
  in
  let ros_arguments =
    let doc =
      "With $(b,--ros2): arguments for ROS 2, up to $(b,--) or the end, as in $(b,--ros-args -r \
       odom:=base/odom -r __node:=follower)."
    in
    Arg.(value & opt_all string [] & info [ "ros-args" ] ~docv:"ARG" ~doc)
  in
  let way device ros2 ros_arguments =
    let open Tools.Real_robot in
    match (device, ros2, ros_arguments) with
    | Some _, true, _ ->
        Error "the robot is either on a serial line or in ROS 2: remove --device or --ros2"
    | _, false, _ :: _ -> Error "--ros-args only works with --ros2: add it"
    | _, true, arguments -> Ok (Some (Ros2 arguments, "--ros2"))
    | Some device, false, [] -> Ok (Some (Device device, "--device"))
    | None, false, [] -> Ok None
  in
  let ( let* ) = Reporting.( let* ) in
  let make general entry sources device ros2 ros_arguments world record picture look host realtime
      simulator robot file =
    let* look = look in
    let* way = way device ros2 ros_arguments in
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
      $ entry $ sources $ device $ ros2 $ ros_arguments $ world $ record $ picture $ look
      $ Host_option.all for_hosts $ realtime $ Host_option.all for_simulator
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
        "Creates the folder $(b,frob-demo) with a program that follows walls, its tests and its \
         world, and drives it for a minute in the simulator. If the folder exists, $(tname) uses \
         its files, so that you can change them and run $(tname) again.";
    ]
  in
  command "demo" ~man ~doc:"drive an example in the simulator" Term.(const make $ look)

let view =
  let recording =
    let doc = "The recording, written by $(b,frobc run --record)." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"RUN.csv" ~doc)
  in
  let file =
    let doc = "The $(b,.frob) program that was recorded." in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"FILE" ~doc)
  in
  let port =
    let doc = "The port of the page. The default is any free port." in
    Arg.(value & opt (some int) None & info [ "port" ] ~docv:"N" ~doc)
  in
  let world =
    let doc =
      "The world to draw on the map. The default is the world that $(b,frobc run) would use."
    in
    Arg.(value & opt (some string) None & info [ "world" ] ~docv:"WORLD.toml" ~doc)
  in
  let only_build =
    let doc =
      "Compile the program for the viewer and print the path of the result, without opening the \
       page."
    in
    Arg.(value & flag & info [ "only-build" ] ~doc)
  in
  let why_nan =
    let doc =
      "Do not open the page. Print where NaN in the program's output comes from: the signal that \
       is NaN although no signal that it depends on is NaN, and its line."
    in
    Arg.(value & flag & info [ "why-nan" ] ~doc)
  in
  let compare =
    let doc =
      "A second recording to show over the first one, of this program or of another version of it."
    in
    Arg.(value & opt (some string) None & info [ "compare" ] ~docv:"OTHER.csv" ~doc)
  in
  let seed =
    let doc = "The seed of the run in the simulator, to drive the same run again." in
    Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc)
  in
  let at =
    let doc = "The time to show first, as in $(b,12.5s). The default is the start." in
    let parse text = Result.map_error (fun e -> `Msg e) (Build.Time_span.parse_instant text) in
    let print out at = Format.pp_print_string out (Build.Time_span.print at) in
    let time = Arg.conv (parse, print) in
    Arg.(value & opt (some time) None & info [ "at" ] ~docv:"TIME" ~doc)
  in
  let run general dialect entry sources print port world compare seed at only_build why_nan
      recording file =
    (* The order of `trace` and `run`, which have the program first, is accepted, too. *)
    let is_program name = Filename.check_suffix name ".frob" in
    let recording, file =
      if is_program recording && not (is_program file) then (file, recording) else (recording, file)
    in
    let recording = if only_build && recording = "-" then None else Some recording in
    Viewing.view general ~entry ~sources
      {
        recording;
        dialect;
        browser = not print;
        port;
        world;
        compare;
        seed;
        at;
        only_build;
        why_nan;
      }
      file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs the program again on the recorded inputs, and shows each of its signals at any \
         instant, in plots and in the source. It compares the outputs with the recorded ones.";
      `P
        "The page is only available on this computer, at the printed address. To open it on \
         another computer, run $(b,ssh -L PORT:127.0.0.1:PORT) there and use the same address.";
    ]
  in
  command "view" ~man ~doc:"show a recorded run on a page, at any instant"
    Term.(
      const run $ with_params general $ dialect $ entry $ sources $ print_address $ port $ world
      $ compare $ seed $ at $ only_build $ why_nan $ recording $ file)

let serve =
  let robot =
    some_string "robot" ~docv:"ROBOT"
      ~doc:"The robot, or the file of the module of your own robot. The default is $(b,pioneer)."
  in
  let world =
    some_string "world" ~docv:"WORLD.toml"
      ~doc:"The world of the robot. The default is the room that comes with frobc."
  in
  let host =
    Host_option.(
      all
        [
          one Arg.int ~absent:"1" "seed" ~docv:"N" ~doc:"Seed of all noise.";
          one Arg.int "tcp" ~docv:"PORT"
            ~doc:
              "Listen on this port of 127.0.0.1 instead of a pseudo-terminal; 0 chooses a free \
               port.";
          one Arg.int "camera" ~docv:"PORT"
            ~doc:
              "Serve the images of the world's cameras as MJPEG over HTTP, on this port of \
               127.0.0.1; 0 chooses a free port. Prints a line $(b,camera:) with the address of \
               each camera, for $(b,frobc run --camera) or a browser.";
          time_span "for" ~docv:"TIME" ~doc:"How long to run. By default it runs until you stop it.";
          one Arg.string "model" ~docv:"MODEL" ~print:Fun.id
            ~doc:"The model of the robot, such as $(b,p3dx) for a Pioneer.";
        ])
  in
  let log =
    some_string "log" ~docv:"FILE"
      ~doc:"Log each received command to this file, with its time on the monotonic clock."
  in
  let link =
    some_string "link" ~docv:"PATH" ~doc:"Maintain a symbolic link to the device at this path."
  in
  let sources =
    let doc = "A C file of your own robot, with its body or its board. Can be repeated." in
    Arg.(value & opt_all string [] & info [ "with" ] ~docv:"FILE.c" ~doc)
  in
  let stamped =
    let doc = "With the robot $(b,ros): commands are of the type TwistStamped instead of Twist." in
    Arg.(value & flag & info [ "stamped" ] ~doc)
  in
  let ros_arguments =
    let doc =
      "With the robot $(b,ros): arguments for ROS 2, up to $(b,--) or the end, as in \
       $(b,--ros-args -r odom:=base/odom)."
    in
    Arg.(value & opt_all string [] & info [ "ros-args" ] ~docv:"ARG" ~doc)
  in
  let make robot sources world log link stamped ros_arguments host =
    Tools.Real_robot.serve ~robot ~sources { world; log; link; stamped; ros_arguments; host }
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Simulates a robot that speaks its serial protocol, byte by byte and in real time. The \
         first line on standard output is $(b,device:) and the address to connect to: the path of \
         a pseudo-terminal, or $(b,tcp:127.0.0.1:PORT). The last lines are a summary.";
      `P "SIGUSR1 unplugs the cable; SIGUSR2 plugs it in again and prints the new device.";
      `P
        "The robot $(b,ros) has no serial line: it is a ROS 2 node, which publishes $(b,odom), \
         $(b,scan), $(b,imu) and $(b,/clock), and drives as $(b,cmd_vel) says. Source the setup \
         script of ROS 2 first. The first lines on standard output are the names of the node and \
         of its topics.";
    ]
  in
  command "serve" ~man ~doc:"simulate a robot at a serial port, or in ROS 2"
    Term.(const make $ robot $ sources $ world $ log $ link $ stamped $ ros_arguments $ host)
