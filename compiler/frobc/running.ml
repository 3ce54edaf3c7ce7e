open Cmdliner
open Options
module Simulating = Driver.Simulating
module Tracing = Driver.Tracing
module Viewing = Driver.Viewing
module General = Driver.General

let trace =
  let input =
    let doc =
      "The recorded input, CSV with a header, perhaps compressed ($(b,.csv.gz), $(b,.csv.zst)); \
       $(b,-) is standard input."
    in
    Arg.(value & opt (some string) None & info [ "input" ] ~docv:"IN.csv" ~doc)
  in
  let output =
    let doc = "Where the output goes, instead of standard output." in
    Arg.(value & opt (some string) None & info [ "output" ] ~docv:"OUT.csv" ~doc)
  in
  let engine =
    let doc =
      "What runs the program: $(b,c), the compiled C, or $(b,interp), the reference interpreter. \
       Both give the same output."
    in
    let engines = [ ("c", Tracing.C); ("interp", Tracing.Interpreter) ] in
    Arg.(value & opt (enum engines) Tracing.C & info [ "engine" ] ~docv:"ENGINE" ~doc)
  in
  let modes =
    let doc =
      "Add a column for each machine of switches or tasks, $(b,mode.NAME), with the name of the \
       mode that runs after the instant."
    in
    Arg.(value & flag & info [ "modes" ] ~doc)
  in
  let picture =
    let doc =
      "Draw the columns of the output, inner signals too, over the time, instead of printing them."
    in
    Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)
  in
  let run general entry sources modes input output picture engine file =
    Tracing.trace general engine ~entry ~sources ~modes ~input ~output ~picture file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "The input is CSV. Its first line names the columns: $(b,time), the seconds of each \
         instant, and one for each part of the program's input: $(b,in) for a single value, \
         $(b,in.1) and $(b,in.2) for a pair, $(b,in.heading) for the field of a record. With \
         another header the right one is shown.";
      `P
        "Numbers are in units of scale 1 (m, s, rad); truth is $(b,true) or $(b,false); other data \
         is written as in a program, as $(b,At 0.5). The cell of an event is empty where it does \
         not occur. The output has the columns $(b,time) and $(b,out); an input may have them too, \
         as a recording of $(b,frobc run) does, and they are not read.";
    ]
  in
  command "trace" ~man ~doc:"run a signal function on recorded input"
    Term.(
      const run
      $ judging (with_params probed)
      $ entry $ sources $ modes $ input $ output $ picture $ engine $ file)

let run =
  let some_string names ~docv ~doc = Arg.(value & opt (some string) None & info names ~docv ~doc) in
  let world =
    some_string [ "world" ] ~docv:"WORLD.toml"
      ~doc:
        "The world to drive in. Without it: $(b,world.toml) beside the program, or else the room \
         that comes with frobc."
  in
  let duration =
    let doc =
      "How long to run, as $(b,60s), $(b,500ms), $(b,2min). Without it: a minute in the simulator, \
       and until it is ended on a robot."
    in
    Arg.(value & opt (some time_span) None & info [ "for" ] ~docv:"TIME" ~doc)
  in
  let rate =
    let doc = "Steps of the controller per second." in
    Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc)
  in
  let seed =
    let doc = "Seed of all noise: the same seed gives the same run." in
    Arg.(value & opt (some int) None & info [ "seed" ] ~docv:"N" ~doc ~absent:"1")
  in
  let realtime =
    let doc = "Run no faster than the clock on the wall, as a robot does in any case." in
    Arg.(value & flag & info [ "realtime" ] ~doc)
  in
  let record =
    some_string [ "record" ] ~docv:"LOG.csv"
      ~doc:
        "Write every instant's input and output, in the format of $(b,frobc trace); compressed, if \
         the name ends in $(b,.gz) or $(b,.zst)."
  in
  let picture =
    some_string [ "picture" ] ~docv:"P.svg|P.png"
      ~doc:"Draw the world, the path driven and the signals."
  in
  let strict =
    Arg.(value & flag & info [ "strict" ] ~doc:"End with status 4 when the robot hits something.")
  in
  let exit_when_done =
    Arg.(
      value & flag
      & info [ "exit-when-done" ]
          ~doc:"End when the program's task has ended, and not after the time that is set.")
  in
  let console =
    let doc = "Give the keys that are typed to the program, one at each instant." in
    Arg.(value & flag & info [ "console" ] ~doc)
  in
  let look =
    let parts = [ ("print", `Print); ("control", `Control) ] in
    let doc =
      "Show the run while it goes on, on a page with all signals, in real time; without $(b,--for) \
       until it is stopped. Prints the page's address and opens a browser, if there is a desktop. \
       $(b,--view=print): opens none. $(b,--view=control): pages may send events to a real robot, \
       too, and not only stop it. $(b,--view=print,control): both."
    in
    let make = function
      | None -> None
      | Some parts ->
          Some { Viewing.browser = not (List.mem `Print parts); control = List.mem `Control parts }
    in
    Term.(
      const make
      $ Arg.(
          value
          & opt ~vopt:(Some []) (some (list (enum parts))) None
          & info [ "view" ] ~docv:"HOW" ~doc))
  in
  let device =
    some_string [ "device" ] ~docv:"DEV"
      ~doc:
        "Run on the robot behind this serial line (a path, best one below $(b,/dev/serial/by-id)) \
         or this address ($(b,tcp:HOST:PORT)) instead of in the simulator."
  in
  let span name ~doc = Arg.(value & opt (some time_span) None & info [ name ] ~docv:"TIME" ~doc) in
  let patience =
    span "patience"
      ~doc:
        "With $(b,--device): how old the newest reading may be, and how long a step may take, \
         before the robot is stopped (200ms)."
  in
  let reconnect =
    span "reconnect" ~doc:"With $(b,--device): how long to wait for a robot that was lost (30s)."
  in
  let settings =
    let doc =
      "With $(b,--device): change a setting of the robot's driver, or of a camera, as \
       $(b,camera.up=0.3); a wrong one lists them all."
    in
    Arg.(value & opt_all string [] & info [ "set" ] ~docv:"NAME=VALUE" ~doc)
  in
  let cameras =
    let doc =
      "With $(b,--device): where the frames of the program's camera come from. A device \
       ($(b,/dev/video0)); a stream of MJPEG ($(b,http://HOST:PORT/PATH)); a folder of pictures; a \
       pipe or a file of pictures (PPM, PGM, JPEG), or of raw frames whose $(b,camera.width) and \
       $(b,camera.height) are set by $(b,--set). Of a program with several cameras: \
       $(b,LABEL=SOURCE), for each."
    in
    Arg.(value & opt_all string [] & info [ "camera" ] ~docv:"SOURCE" ~doc)
  in
  let priority =
    let doc = "With $(b,--device): run with this real-time priority, 1 to 99." in
    Arg.(value & opt (some int) None & info [ "priority" ] ~docv:"N" ~doc)
  in
  let lock_memory =
    let doc = "With $(b,--device): keep the program's memory from being swapped out." in
    Arg.(value & flag & info [ "lock-memory" ] ~doc)
  in
  let on_robot device duration rate record patience reconnect settings cameras priority lock_memory
      exit_when_done console look =
    match device with
    | Some device ->
        Ok
          {
            Driver.Real_robot.device;
            duration;
            rate;
            record;
            patience;
            reconnect;
            settings;
            cameras;
            priority;
            lock_memory;
            exit_when_done;
            console;
            look;
          }
    | None ->
        let given name option = if option then Some name else None in
        Error
          (List.filter_map Fun.id
             [
               given "--patience" (patience <> None);
               given "--reconnect" (reconnect <> None);
               given "--set" (settings <> []);
               given "--camera" (cameras <> []);
               given "--priority" (priority <> None);
               given "--lock-memory" lock_memory;
             ])
  in
  let on_robot =
    Term.(
      const on_robot $ device $ duration $ rate $ record $ patience $ reconnect $ settings $ cameras
      $ priority $ lock_memory $ exit_when_done $ console $ look)
  in
  let make general entry sources on_robot world duration rate seed realtime record picture strict
      exit_when_done console look file =
    match on_robot with
    | Error (option :: _) ->
        let other =
          if option = "--set" then "; a parameter of the program is set by --param" else ""
        in
        General.wrong_use
          (Printf.sprintf "%s is for a robot, and not for the simulator: it needs --device%s" option
             other)
    | Ok run ->
        let given name = Option.map (fun _ -> name) in
        let simulated =
          List.filter_map Fun.id
            [
              given "--world" world;
              given "--picture" picture;
              given "--seed" seed;
              (if strict then Some "--strict" else None);
            ]
        in
        Driver.Real_robot.run general ~entry ~sources ~simulated run file
    | Error [] ->
        let seed = Option.value seed ~default:1 in
        Simulating.run general ~entry ~sources
          {
            Simulating.world;
            duration;
            rate;
            seed;
            realtime;
            record;
            picture;
            strict;
            exit_when_done;
            console;
            look;
          }
          file
  in
  command "run" ~doc:"run a robot program in the simulator, or on a robot"
    Term.(
      const make
      $ judging (with_params probed)
      $ entry $ sources $ on_robot $ world $ duration $ rate $ seed $ realtime $ record $ picture
      $ strict $ exit_when_done $ console $ look $ file)

let view =
  let recording =
    let doc = "The recording: what $(b,frobc run --record) wrote." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"RUN.csv" ~doc)
  in
  let file =
    let doc = "The $(b,.frob) program that was recorded." in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"FILE" ~doc)
  in
  let print =
    let doc = "Print the page's address, and open no browser." in
    Arg.(value & flag & info [ "print" ] ~doc)
  in
  let port =
    let doc = "The port for the page; without it, any that is free." in
    Arg.(value & opt (some int) None & info [ "port" ] ~docv:"N" ~doc)
  in
  let world =
    let doc =
      "The world that is drawn on the map. Without it: the one that $(b,frobc run) would take."
    in
    Arg.(value & opt (some string) None & info [ "world" ] ~docv:"WORLD.toml" ~doc)
  in
  let only_build =
    let doc = "Compile the program as it is to be run, print the path of that, and show nothing." in
    Arg.(value & flag & info [ "only-build" ] ~doc)
  in
  let seed =
    let doc = "The seed with which a run was made in the simulator, if it is to drive again." in
    Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc)
  in
  let at =
    let doc = "The time to show at first, as $(b,12.5s), instead of the start." in
    let parse text = Result.map_error (fun e -> `Msg e) (Driver.Time_span.parse_instant text) in
    let print out at = Format.pp_print_string out (Driver.Time_span.print at) in
    let time = Arg.conv (parse, print) in
    Arg.(value & opt (some time) None & info [ "at" ] ~docv:"TIME" ~doc)
  in
  let run general entry sources print port world seed at only_build recording file =
    let recording = if only_build && recording = "-" then None else Some recording in
    Viewing.view general ~entry ~sources
      { recording; browser = not print; port; world; seed; at; only_build }
      file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "The program is run again on the inputs that were recorded, so that each of its signals \
         can be seen at any instant: in plots, and in its source. Its outputs are compared with \
         those recorded.";
      `P
        "The page is served to this computer alone, and only to who knows the address that is \
         printed. From another computer: $(b,ssh -L PORT:127.0.0.1:PORT), and the same address \
         there.";
    ]
  in
  command "view" ~man ~doc:"look at a recorded run on a page, at any instant"
    Term.(
      const run $ with_params general $ entry $ sources $ print $ port $ world $ seed $ at
      $ only_build $ recording $ file)

let serve =
  let some kind names ~docv ~doc = Arg.(value & opt (some kind) None & info names ~docv ~doc) in
  let robot =
    some Arg.string [ "robot" ] ~docv:"ROBOT"
      ~doc:"The robot; without it, a $(b,pioneer). Or the file of the module of one of your own."
  in
  let world =
    some Arg.string [ "world" ] ~docv:"WORLD.toml"
      ~doc:"The world it is in. Without it: the room that comes with frobc."
  in
  let seed = Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc:"Seed of all noise.") in
  let tcp =
    some Arg.int [ "tcp" ] ~docv:"PORT"
      ~doc:"Listen on this port of 127.0.0.1 instead of a pseudo-terminal; 0 takes a free one."
  in
  let camera =
    some Arg.int [ "camera" ] ~docv:"PORT"
      ~doc:
        "Give what the cameras of the world see as MJPEG over HTTP, on this port of 127.0.0.1; 0 \
         takes a free one. A line $(b,camera:) for each tells its address, for $(b,frobc run \
         --camera) or a browser."
  in
  let duration =
    some time_span [ "for" ] ~docv:"TIME" ~doc:"How long to run. Without it: until it is ended."
  in
  let model =
    some Arg.string [ "model" ] ~docv:"MODEL" ~doc:"The model, such as $(b,p3dx) for a Pioneer."
  in
  let log =
    some Arg.string [ "log" ] ~docv:"FILE"
      ~doc:"Write each command that arrives, with its time on the monotonic clock."
  in
  let link =
    some Arg.string [ "link" ] ~docv:"PATH" ~doc:"Keep a symbolic link to the device there."
  in
  let sources =
    let doc =
      "A C file of a robot of your own: its body and its board; may be given several times."
    in
    Arg.(value & opt_all string [] & info [ "with" ] ~docv:"FILE.c" ~doc)
  in
  let make robot sources world seed tcp camera duration model log link =
    Driver.Real_robot.serve ~robot ~sources { world; seed; tcp; camera; duration; model; log; link }
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "A simulated robot that speaks its serial protocol, byte by byte and in real time. The \
         first line on standard output is $(b,device:) and what to connect to: the path of a \
         pseudo-terminal, or $(b,tcp:127.0.0.1:PORT). At the end there is a summary.";
      `P "SIGUSR1 pulls the cable; SIGUSR2 plugs it in again, and tells the new device.";
    ]
  in
  command "serve" ~man ~doc:"a simulated robot behind a serial line"
    Term.(
      const make $ robot $ sources $ world $ seed $ tcp $ camera $ duration $ model $ log $ link)
