open Cmdliner
open Options
module Commands = Driver.Commands
module General = Driver.General

let trace =
  let input =
    let doc = "The recorded input, CSV with a header; $(b,-) is standard input." in
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
    let engines = [ ("c", Commands.C); ("interp", Commands.Interpreter) ] in
    Arg.(value & opt (enum engines) Commands.C & info [ "engine" ] ~docv:"ENGINE" ~doc)
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
    Commands.trace general engine ~entry ~sources ~modes ~input ~output ~picture file
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
        "Numbers are in units of scale 1 (m, s, rad); truth is $(b,true) or $(b,false); other \
         data is written as in a program, as $(b,At 0.5). The cell of an event is empty where it \
         does not occur. The output has the columns $(b,time) and $(b,out); an input may have \
         them too, as a recording of $(b,frobc run) does, and they are not read.";
    ]
  in
  command "trace" ~man ~doc:"run a signal function on recorded input"
    Term.(
      const run $ judging (with_params probed) $ entry $ sources $ modes $ input $ output $ picture
      $ engine $ file)

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
      "How long to run, as $(b,60s), $(b,500ms), $(b,2min). Without it: a minute in the \
       simulator, and until it is ended on a robot."
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
      ~doc:"Write every instant's input and output, in the format of $(b,frobc trace)."
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
          Some { Commands.browser = not (List.mem `Print parts); control = List.mem `Control parts }
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
        "Run on the robot behind this serial line (a path, best one below \
         $(b,/dev/serial/by-id)) or this address ($(b,tcp:HOST:PORT)) instead of in the simulator."
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
  let on_robot device duration rate record patience reconnect settings cameras priority
      lock_memory exit_when_done console look =
    match device with
    | Some device ->
        Ok
          {
            Driver.Real_robot.device; duration; rate; record; patience; reconnect; settings;
            cameras; priority; lock_memory; exit_when_done; console; look;
          }
    | None ->
        let given name option = if option then Some name else None in
        Error
          (List.filter_map Fun.id
             [
               given "--patience" (patience <> None); given "--reconnect" (reconnect <> None);
               given "--set" (settings <> []); given "--camera" (cameras <> []);
               given "--priority" (priority <> None);
               given "--lock-memory" lock_memory;
             ])
  in
  let on_robot =
    Term.(
      const on_robot $ device $ duration $ rate $ record $ patience $ reconnect $ settings
      $ cameras $ priority $ lock_memory $ exit_when_done $ console $ look)
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
              given "--world" world; given "--picture" picture; given "--seed" seed;
              (if strict then Some "--strict" else None);
            ]
        in
        Driver.Real_robot.run general ~entry ~sources ~simulated run file
    | Error [] ->
        let seed = Option.value seed ~default:1 in
        Commands.run general ~entry ~sources
          { Commands.world; duration; rate; seed; realtime; record; picture; strict; exit_when_done;
            console; look }
          file
  in
  command "run" ~doc:"run a robot program in the simulator, or on a robot"
    Term.(
      const make $ judging (with_params probed) $ entry $ sources $ on_robot $ world $ duration
      $ rate $ seed $ realtime $ record $ picture $ strict $ exit_when_done $ console $ look $ file)

let test =
  let paths =
    let doc =
      "A $(b,.frob) file, or a folder: all files in it with tests. Without any: this folder."
    in
    Arg.(value & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let pattern =
    let doc = "Run only tests whose label has this text in it." in
    Arg.(value & opt (some string) None & info [ "k" ] ~docv:"TEXT" ~doc)
  in
  let seeds =
    let doc = "Run each trial with so many seeds, from its first on, instead of as it says." in
    Arg.(value & opt (some int) None & info [ "seeds" ] ~docv:"N" ~doc)
  in
  let jobs =
    let doc = "So many processes at a time; without it, as many as there are processors." in
    Arg.(value & opt (some int) None & info [ "j"; "jobs" ] ~docv:"N" ~doc)
  in
  let rate =
    let doc = "Instants a second." in
    Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc)
  in
  let json =
    let doc = "Print an object a line, for tools, with each run of a trial." in
    Arg.(value & flag & info [ "json" ] ~doc)
  in
  let junit =
    let doc = "Write what became of the tests as a JUnit document, for a CI server." in
    Arg.(value & opt (some string) None & info [ "junit" ] ~docv:"FILE.xml" ~doc)
  in
  let keep =
    let doc = "The folder for a recording and a picture of each trial that fails." in
    Arg.(value & opt string "failed" & info [ "keep" ] ~docv:"DIR" ~doc)
  in
  let update =
    let doc = "Write the output files of golden traces anew, where they have changed." in
    Arg.(value & flag & info [ "update" ] ~doc)
  in
  let run general sources pattern seeds jobs rate json junit update keep paths =
    let positive name = function
      | Some n when n < 1 -> Error (Printf.sprintf "%s takes a number of at least 1" name)
      | _ -> Ok ()
    in
    match (positive "--seeds" seeds, positive "--jobs" jobs) with
    | Error text, _ | _, Error text -> General.wrong_use text
    | Ok (), Ok () when not (rate >= 0.1 && rate <= 10000.) ->
        General.wrong_use "--rate takes a number from 0.1 to 10000"
    | Ok (), Ok () ->
        Driver.Trials.run general ~sources
          { Driver.Checking.pattern; seeds; jobs; rate; json; junit; update; keep }
          paths
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs what programs say of themselves: $(b,test \"label\" = during 2[s] observer), \
         $(b,test \"label\" = trace \"in.csv\" \"out.csv\"), and \
         $(b,trial \"label\" = Trial { … }), which drives the program in the simulator with many \
         seeds and judges what really happens. A line for each; of a trial that fails the seed, \
         when, what was there, a picture, and the command that shows the run.";
      `P "The exit status is 1 if a test fails.";
    ]
  in
  command "test" ~man ~doc:"run the tests and trials that are written in programs"
    Term.(
      const run $ general $ sources $ pattern $ seeds $ jobs $ rate $ json $ junit $ update $ keep
      $ paths)

let sweep =
  let plan =
    let doc = "The plan: what is varied, in TOML." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"PLAN.toml" ~doc)
  in
  let jobs =
    let doc = "So many processes at a time; without it, as many as there are processors." in
    Arg.(value & opt (some int) None & info [ "j"; "jobs" ] ~docv:"N" ~doc)
  in
  let shard =
    let doc =
      "Make only the K-th of N parts of the runs, as $(b,3/100): for a batch system, each part on \
       a machine. $(b,--merge) makes the table then."
    in
    let parse text =
      match List.map int_of_string_opt (String.split_on_char '/' text) with
      | [ Some number; Some of_ ] when number >= 1 && number <= of_ ->
          Ok { Driver.Runs.number; of_ }
      | _ -> Error (`Msg (Printf.sprintf "`%s` is no shard; the third of a hundred is 3/100" text))
    in
    let print out { Driver.Runs.number; of_ } = Format.fprintf out "%d/%d" number of_ in
    Arg.(
      value
      & opt (conv (parse, print)) { Driver.Runs.number = 1; of_ = 1 }
      & info [ "shard" ] ~docv:"K/N" ~doc)
  in
  let merge =
    let doc = "Make no runs, but the table of the rows that are there." in
    Arg.(value & flag & info [ "merge" ] ~doc)
  in
  let rows =
    let doc = "The folder where rows are kept; without it, $(b,PLAN.rows) beside the plan." in
    Arg.(value & opt (some string) None & info [ "rows" ] ~docv:"DIR" ~doc)
  in
  let also =
    let doc = "One more folder with rows, of another machine; may be given several times." in
    Arg.(value & opt_all string [] & info [ "also" ] ~docv:"DIR" ~doc)
  in
  let table =
    let doc = "Where the table goes; without it, $(b,PLAN.csv) beside the plan." in
    Arg.(value & opt (some string) None & info [ "table" ] ~docv:"T.csv" ~doc)
  in
  let picture =
    let doc = "Draw a heat map over two parameters, a line over one, or else histograms." in
    Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)
  in
  let run general sources jobs shard merge rows also table picture plan =
    match (jobs, List.find_opt (fun folder -> not (Sys.file_exists folder)) also) with
    | Some n, _ when n < 1 -> General.wrong_use "--jobs takes a number of at least 1"
    | _, Some folder -> General.wrong_use (Printf.sprintf "there is no folder %s" folder)
    | _, None ->
        Driver.Sweep.run general ~sources
          { Driver.Sweep.jobs; shard; merge; rows; also; table; picture }
          plan
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Makes many runs of a trial, over worlds, robots, values of parameters and seeds, and a \
         table with a row for each: what became of it, and what the trial measures.";
      `Pre
        "program = \"wall_follow.frob\"\n\
         seeds = [1, 20]\n\n\
         [params]\n\
         gap = \"0.2[m] to 0.6[m], 9 steps\"";
      `P
        "Each row is kept as soon as its run is done. Whatever ends a sweep, the same command goes \
         on where it ended; a plan with more runs makes only those that are new.";
    ]
  in
  command "sweep" ~man ~doc:"make many runs of a trial, and a table of them"
    Term.(
      const run $ general $ sources $ jobs $ shard $ merge $ rows $ also $ table $ picture $ plan)

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
  let run general entry sources print port world seed only_build recording file =
    let recording = if only_build && recording = "-" then None else Some recording in
    Commands.view general ~entry ~sources
      { recording; browser = not print; port; world; seed; only_build }
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
      const run $ with_params general $ entry $ sources $ print $ port $ world $ seed
        $ only_build $ recording $ file)

let serve =
  let some kind names ~docv ~doc = Arg.(value & opt (some kind) None & info names ~docv ~doc) in
  let robot =
    some Arg.string [ "robot" ] ~docv:"ROBOT"
      ~doc:
        "The robot; without it, a $(b,pioneer). Or the file of the module of one of your own."
  in
  let world =
    some Arg.string [ "world" ] ~docv:"WORLD.toml"
      ~doc:"The world it is in. Without it: the room that comes with frobc."
  in
  let seed =
    Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc:"Seed of all noise.")
  in
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
