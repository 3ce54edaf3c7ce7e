(* The command line of frobc. What the commands do is in {!Driver.Commands};
   here are only their options and texts. *)

open Cmdliner
module Commands = Driver.Commands
module Stage = Driver.Stage

let exits =
  [
    Cmd.Exit.info Driver.Exit_status.ok ~doc:"done.";
    Cmd.Exit.info Driver.Exit_status.rejected
      ~doc:"the program was rejected; diagnostics are on standard error.";
    Cmd.Exit.info Driver.Exit_status.wrong_use
      ~doc:"wrong use, missing file, unreadable input, or missing tool.";
    Cmd.Exit.info Driver.Exit_status.bug ~doc:"a bug in frobc.";
    Cmd.Exit.info Driver.Exit_status.fault
      ~doc:"the run ended in a fault: robot lost, watchdog, collision limit, assertion violated.";
  ]

let command name ~doc ?man term = Cmd.v (Cmd.info name ~doc ?man ~exits) term

(* {1 Arguments that commands share} *)

let file =
  Arg.(required & pos 0 (some string) None & info [] ~docv:"FILE" ~doc:"The $(b,.frob) program.")

let files =
  Arg.(non_empty & pos_all string [] & info [] ~docv:"FILE" ~doc:"A $(b,.frob) module.")

let entry =
  let doc = "The value to compile: a program or a closed signal function." in
  Arg.(value & opt string "main" & info [ "entry" ] ~docv:"NAME" ~doc)

let sources =
  let doc =
    "A C or C++ file that a program with foreign code is compiled with, or a compiled one to link; \
     may be given several times."
  in
  Arg.(value & opt_all string [] & info [ "with" ] ~docv:"FILE.c" ~doc)

let stage =
  let parse text =
    match Stage.of_name text with
    | Some stage -> Ok stage
    | None ->
        let names = String.concat ", " (List.map Stage.name Stage.all) in
        Error (`Msg (Printf.sprintf "`%s` is not a stage; the stages are %s" text names))
  in
  Arg.conv (parse, fun ppf stage -> Format.pp_print_string ppf (Stage.name stage))

let stages_doc =
  String.concat "; "
    (List.map (fun s -> Printf.sprintf "$(b,%s) (%s)" (Stage.name s) (Stage.meaning s)) Stage.all)

let robot_names =
  String.concat ", " (List.map (Printf.sprintf "$(b,%s)") Driver.Robots.names)

let real =
  let doc =
    "What the program computes $(b,Float) with: $(b,double), or $(b,float), single precision, \
     for microcontrollers that have no other arithmetic."
  in
  let precisions = [ ("double", Basis.Real.Double); ("float", Single) ] in
  Arg.(value & opt (enum precisions) Basis.Real.Double & info [ "real" ] ~docv:"TYPE" ~doc)

let general =
  let format =
    let doc =
      "How diagnostics, and a report, are written: $(b,text), or $(b,json), one object a line."
    in
    Arg.(
      value
      & opt (enum [ ("text", Commands.Text); ("json", Commands.Json) ]) Commands.Text
      & info [ "format" ] ~docv:"FORMAT" ~doc)
  in
  let dump =
    let doc = "Print the program as it is after a stage of the compiler: " ^ stages_doc ^ "." in
    Arg.(value & opt (some stage) None & info [ "dump" ] ~docv:"STAGE" ~doc)
  in
  let stop_after =
    let doc = "End after a stage of the compiler; for the names see $(b,--dump)." in
    Arg.(value & opt (some stage) None & info [ "stop-after" ] ~docv:"STAGE" ~doc)
  in
  let lint =
    let doc = "Check what the compiler promises itself after each stage." in
    Arg.(value & flag & info [ "lint" ] ~doc)
  in
  let limit =
    let doc =
      "How many specialized copies one definition may have before the program is rejected."
    in
    Arg.(value & opt int 10_000 & info [ "specialization-limit" ] ~docv:"N" ~doc)
  in
  let robot =
    let doc =
      "The robot to compile for: " ^ robot_names
      ^ ", or, for one of your own, the file of its module, as in $(b,Rover.frob)."
    in
    Arg.(value & opt (some string) None & info [ "robot" ] ~docv:"ROBOT" ~doc)
  in
  let make format dump stop_after lint specialization_limit robot real =
    { Commands.format; dump; stop_after; lint; specialization_limit; robot; real; probes = [];
      asserts = Off; params = [] }
  in
  Term.(const make $ format $ dump $ stop_after $ lint $ limit $ robot $ real)

let probed =
  let doc =
    "Show inner signals too, each in a column $(b,probe.NAME): those whose names end in NAME, as \
     $(b,v) or $(b,wallFollow.v); all of a signal function that runs, as $(b,wallFollow); or \
     $(b,all). May be given several times; $(b,list) prints what there is."
  in
  let names = Arg.(value & opt_all (list string) [] & info [ "probe" ] ~docv:"NAME,…" ~doc) in
  let make general names = { general with Commands.probes = List.concat names } in
  Term.(const make $ general $ names)

(* Of a command; [default]: without the option. *)
let with_asserts ~default ~doc general =
  let all = [ ("off", Commands.Off); ("count", Commands.Count); ("stop", Commands.Stop) ] in
  let asserts = Arg.(value & opt (enum all) default & info [ "asserts" ] ~docv:"HOW" ~doc) in
  Term.(const (fun general asserts -> { general with Commands.asserts }) $ general $ asserts)

let judging general =
  with_asserts general ~default:Commands.Count
    ~doc:
      "What is done with the program's assertions: $(b,count) them and tell what became of each, \
       $(b,stop) at the first that is violated, with the robot at rest and exit status 4, or \
       $(b,off)."

let not_judging general =
  with_asserts general ~default:Commands.Off
    ~doc:
      "With $(b,count), or $(b,stop), the program's assertions are compiled too, and its table for \
       hosts has their verdicts; with $(b,off), as without it, nothing of them is."

(* Of commands that run a program. *)
let with_params general =
  let doc =
    "Run with this value of a parameter that the program declares by $(b,param), as in \
     $(b,kTurn=5[1/m]): an expression as the program could have it, of the parameter's unit. May \
     be given several times."
  in
  let settings = Arg.(value & opt_all string [] & info [ "param" ] ~docv:"NAME=VALUE" ~doc) in
  let make general params = { general with Commands.params } in
  Term.(const make $ general $ settings)

let time_span =
  let parse text = Result.map_error (fun message -> `Msg message) (Driver.Time_span.parse text) in
  Arg.conv (parse, fun ppf seconds -> Format.fprintf ppf "%gs" seconds)

(* {1 Commands} *)

let check =
  command "check" ~doc:"say what is wrong with programs or modules; nothing is written"
    Term.(const Commands.check $ general $ files)

let format =
  let check =
    let doc =
      "Write nothing; print the files that would change, each with its first line that would, \
       and exit with 1 if there are any."
    in
    Arg.(value & flag & info [ "check" ] ~doc)
  in
  let files =
    let doc = "A $(b,.frob) file; $(b,-) is standard input, which goes to standard output." in
    Arg.(non_empty & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Blanks, indentation and empty lines come to be as in the library and the examples. Lines \
         stay where they are broken, and are broken where they have more than 100 characters; \
         what is aligned by blanks stays so. Nothing else changes: each result is checked to be \
         the same program with the same comments. A file that is no program stays as it is.";
    ]
  in
  command "format" ~man ~doc:"write programs as the library is written, in place"
    Term.(const (fun check files -> Driver.Format_files.run ~check files) $ check $ files)

let fix =
  let diff =
    let doc = "Write nothing; print what would change, as $(b,diff -u) does." in
    Arg.(value & flag & info [ "diff" ] ~doc)
  in
  let all =
    let doc =
      "Make all fixes, also those that may not be what you meant; of several for one place the \
       first."
    in
    Arg.(value & flag & info [ "all" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Many messages of the compiler say what to write instead. Where nothing else can have been \
         meant, $(tname) writes it, looks at the program again, and so on, and prints each \
         fix that it made. What is left to do by hand is printed as $(b,frobc check) does.";
      `P "An editor offers all fixes where they belong: see $(b,frobc lsp).";
    ]
  in
  command "fix" ~man ~doc:"mend what messages say how to mend, in place"
    Term.(
      const (fun general diff all files ->
          Driver.Fix_files.(run general ~diff (if all then All else Safe)) files)
      $ general $ diff $ all $ files)

let compile =
  let folder =
    let doc = "The folder for the C files." in
    Arg.(value & opt string "." & info [ "o"; "output" ] ~docv:"DIR" ~doc)
  in
  let batch =
    let doc =
      "With a function NAME_steps that takes many steps in one call, for replay and simulation."
    in
    Arg.(value & flag & info [ "batch" ] ~doc)
  in
  let standalone =
    let doc =
      "Put into the two files what they need of frobc's own headers and sources, so that they \
       compile anywhere by themselves."
    in
    Arg.(value & flag & info [ "standalone" ] ~doc)
  in
  let run general entry batch standalone folder file =
    Commands.compile general entry ~batch ~standalone folder file
  in
  command "compile" ~doc:"translate a program to C: NAME.c and NAME.h"
    Term.(const run $ not_judging general $ entry $ batch $ standalone $ folder $ file)

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
      "With $(b,--device): change a setting of the robot's driver; a wrong one lists them all."
    in
    Arg.(value & opt_all string [] & info [ "set" ] ~docv:"NAME=VALUE" ~doc)
  in
  let priority =
    let doc = "With $(b,--device): run with this real-time priority, 1 to 99." in
    Arg.(value & opt (some int) None & info [ "priority" ] ~docv:"N" ~doc)
  in
  let lock_memory =
    let doc = "With $(b,--device): keep the program's memory from being swapped out." in
    Arg.(value & flag & info [ "lock-memory" ] ~doc)
  in
  let on_robot device duration rate record patience reconnect settings priority lock_memory
      exit_when_done console look =
    match device with
    | Some device ->
        Ok
          {
            Driver.Real_robot.device; duration; rate; record; patience; reconnect; settings;
            priority; lock_memory; exit_when_done; console; look;
          }
    | None ->
        let given name option = if option then Some name else None in
        Error
          (List.filter_map Fun.id
             [
               given "--patience" (patience <> None); given "--reconnect" (reconnect <> None);
               given "--set" (settings <> []); given "--priority" (priority <> None);
               given "--lock-memory" lock_memory;
             ])
  in
  let on_robot =
    Term.(
      const on_robot $ device $ duration $ rate $ record $ patience $ reconnect $ settings
      $ priority $ lock_memory $ exit_when_done $ console $ look)
  in
  let make general entry sources on_robot world duration rate seed realtime record picture strict
    exit_when_done console look file =
    match on_robot with
    | Error (option :: _) ->
        let other =
          if option = "--set" then "; a parameter of the program is set by --param" else ""
        in
        Commands.wrong_use
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
  let run general sources pattern seeds jobs rate json junit keep paths =
    let positive name = function
      | Some n when n < 1 -> Error (Printf.sprintf "%s takes a number of at least 1" name)
      | _ -> Ok ()
    in
    match (positive "--seeds" seeds, positive "--jobs" jobs) with
    | Error text, _ | _, Error text -> Commands.wrong_use text
    | Ok (), Ok () when not (rate >= 0.1 && rate <= 10000.) ->
        Commands.wrong_use "--rate takes a number from 0.1 to 10000"
    | Ok (), Ok () ->
        Driver.Trials.run general ~sources { pattern; seeds; jobs; rate; json; junit; keep } paths
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs what programs say of themselves: $(b,test \"label\" = during 2[s] observer), and \
         $(b,trial \"label\" = Trial { … }), which drives the program in the simulator with many \
         seeds and judges what really happens. A line for each; of a trial that fails the seed, \
         when, what was there, a picture, and the command that shows the run.";
      `P "The exit status is 1 if a test fails.";
    ]
  in
  command "test" ~man ~doc:"run the tests and trials that are written in programs"
    Term.(
      const run $ general $ sources $ pattern $ seeds $ jobs $ rate $ json $ junit $ keep $ paths)

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

let build =
  let output =
    let doc = "Where to write it; without it, the program's name." in
    Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv:"EXE" ~doc)
  in
  let target =
    let describe name =
      let meaning = Option.fold ~none:"" ~some:Driver.Target.meaning (Driver.Target.of_name name) in
      Printf.sprintf "$(b,%s) (%s)" name meaning
    in
    let doc =
      "The machine to build for: " ^ String.concat "; " (List.map describe Driver.Target.names)
        ^ "."
    in
    Arg.(value & opt string "host" & info [ "target" ] ~docv:"TARGET" ~doc)
  in
  command "build" ~doc:"the executable that $(b,run --device) would start"
    Term.(
      const (fun general entry sources target output file ->
          Driver.Real_robot.build general ~entry ~sources ~target ~output file)
      $ not_judging general $ entry $ sources $ target $ output $ file)

let export =
  let folder =
    let doc =
      "Write a library folder for PlatformIO: library.json, the C in $(b,src), and a main program \
       for boards with the Arduino framework in $(b,examples), in a folder of the program's name."
    in
    Arg.(required & opt (some string) None & info [ "platformio" ] ~docv:"DIR" ~doc)
  in
  command "export" ~doc:"a robot program as a library for other build tools"
    Term.(
      const (fun general entry sources folder file ->
          Driver.Export.platformio general ~entry ~sources ~folder file)
      $ general $ entry $ sources $ folder $ file)

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
  let make robot sources world seed tcp duration model log link =
    Driver.Real_robot.serve ~robot ~sources { world; seed; tcp; duration; model; log; link }
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
    Term.(const make $ robot $ sources $ world $ seed $ tcp $ duration $ model $ log $ link)

let report =
  let states =
    let doc = "Instead of that the switches and tasks as a state diagram, for Graphviz." in
    Arg.(value & flag & info [ "states" ] ~doc)
  in
  command "report" ~doc:"memory, operations and stack of a step, stated before it runs"
    Term.(
      const (fun general entry states file -> Commands.report general ~entry ~states file)
      $ general $ entry $ states $ file)

let header =
  let robot =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"ROBOT" ~doc:("The robot: " ^ robot_names
        ^ ", or the file of the module of one of your own."))
  in
  command "header" ~doc:"the C header with a robot's input and output types"
    Term.(const Commands.header $ robot)

let selftest =
  let some names ~docv ~doc = Arg.(value & opt (some string) None & info names ~docv ~doc) in
  let cc =
    some [ "cc" ] ~docv:"CC"
      ~doc:
        "The C compiler, a command, perhaps with options. Without it: that of the environment \
         variable $(b,CC), or $(b,cc)."
  in
  let cflags =
    some [ "cflags" ] ~docv:"FLAGS"
      ~doc:
        (Printf.sprintf
           "Its options, separated by spaces, for compiling and for linking. Without them: \
            $(b,%s)."
           (String.concat " " Driver.Toolchain.flags))
  in
  let runner =
    some [ "runner" ] ~docv:"COMMAND"
      ~doc:"What runs the programs that a cross compiler makes, such as $(b,qemu-aarch64)."
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Compiles programs that together have every construct of the C that frobc writes, runs \
         them, and compares their outputs with those of the reference interpreter, bit for bit. \
         Prints a line for each of them and the verdict. What is wrong is said on standard error: \
         numbers that are not IEEE 754's (contraction, $(b,-ffast-math), other rounding), code \
         that does not compile, outputs that differ, and what the compiler warns of.";
      `P
        "The exit status is 0 if the compiler is fit, 1 if it is not, and 2 if it could not be \
         tried.";
      `P
        "A compiler for another machine needs an emulator that runs its programs, one for a board \
         also a library that prints through it:";
      `Pre
        "frobc selftest --cc aarch64-linux-gnu-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off -static\" --runner qemu-aarch64\n\
         frobc selftest --cc arm-none-eabi-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off --specs=rdimon.specs\" --runner qemu-arm";
    ]
  in
  command "selftest" ~man ~doc:"whether a C compiler, with its options, is fit for generated C"
    Term.(
      const (fun cc cflags runner real -> Driver.Selftest.run { cc; cflags; runner; real })
      $ cc $ cflags $ runner $ real)

let explain =
  let code =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"CODE" ~doc:"The code of a diagnostic, such as $(b,E0401).")
  in
  command "explain" ~doc:"what a diagnostic means, with an example and its cure"
    Term.(const Commands.explain $ code)

let lsp =
  let stdio =
    let doc = "Standard input and output, as without it: some editors say so." in
    Arg.(value & flag & info [ "stdio" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "An editor starts this and asks it about programs: messages while you type, types, \
         definitions, completion, renaming, and so on, by the Language Server Protocol. How to set \
         up an editor is told in docs/editors.md.";
    ]
  in
  command "lsp" ~man ~doc:"the compiler in an editor"
    Term.(const (fun (_ : bool) -> Language_server.Server.run ()) $ stdio)

let main =
  let doc = "compiler for Frob, a language for programming mobile robots" in
  let man =
    [
      `S Manpage.s_description;
      `P
        "In Frob time is implicit and behaviour is written as equations. $(tname) type-checks a \
         program and turns it into C: no heap, no recursion, memory and time known in advance.";
    ]
  in
  Cmd.group (Cmd.info "frobc" ~version:"0.1" ~doc ~man ~exits)
    [
      check; fix; format; compile; trace; run; test; view; serve; build; export; report; selftest;
      header; explain; lsp;
    ]

(* A compilation is short, and what outlives the minor heap mostly lives to the
   end: marking finds little to free. Without it large programs take a tenth less
   work (and 0.6 GB for 100,000 lines; to free the front end's trees when only Flow is
   wanted would make that 0.5 GB, and take more time than it saves). In a small heap there
   would be marking all the same, as it is done in proportion to what share of the
   heap is new: so the heap grows by 32 MB at a time, of which only what is used is
   real memory. Where hardly anything is freed there is no use in looking for the
   block that fits best (policy 2, the default) either: policy 0 takes the next one;
   nor in moving blocks together (never, with so large an overhead). Nor does the
   buffer of each file that was read ask for marking (the ratio of such memory).
   The minor heap stays as it is: a larger one leaves the processor's cache. *)
let collect_seldom () =
  Gc.set
    {
      (Gc.get ()) with
      space_overhead = 10_000;
      max_overhead = 1_000_000;
      major_heap_increment = 4 * 1024 * 1024;
      allocation_policy = 0;
      custom_major_ratio = 1_000_000;
    }

(* The flags of a C compiler begin as options do: `--cflags -O2`. *)
let rec with_flags = function
  | "--cflags" :: flags :: rest -> ("--cflags=" ^ flags) :: with_flags rest
  | argument :: rest -> argument :: with_flags rest
  | [] -> []

let argv = Array.of_list (with_flags (Array.to_list Sys.argv))

let () =
  collect_seldom ();
  Driver.Streams.keep_numbers ();
  let status =
    match Cmd.eval_value ~catch:false ~argv main with
    | Ok (`Ok status) -> status
    | Ok (`Version | `Help) -> Driver.Exit_status.ok
    | Error (`Parse | `Term) -> Driver.Exit_status.wrong_use
    | Error `Exn -> Driver.Exit_status.bug
    | exception exn when Driver.Streams.output_fault () = None -> Commands.report_exception exn
    | exception _ -> Driver.Exit_status.wrong_use
  in
  let status =
    match Driver.Streams.output_fault () with
    | None -> status
    | Some reason ->
        Printf.eprintf "error: cannot write standard output: %s\n" reason;
        if status = Driver.Exit_status.ok then Driver.Exit_status.wrong_use else status
  in
  Driver.Streams.drop_unwritable ();
  exit status
