open Cmdliner
module General = Driver.General
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

let file =
  Arg.(required & pos 0 (some string) None & info [] ~docv:"FILE" ~doc:"The $(b,.frob) program.")

let files = Arg.(non_empty & pos_all string [] & info [] ~docv:"FILE" ~doc:"A $(b,.frob) module.")

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

let robot_names = String.concat ", " (List.map (Printf.sprintf "$(b,%s)") Driver.Robots.names)

let real =
  let doc =
    "What the program computes $(b,Float) with: $(b,double), or $(b,float), single precision, for \
     microcontrollers that have no other arithmetic."
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
      & opt (enum [ ("text", General.Text); ("json", General.Json) ]) General.Text
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
    {
      General.format;
      dump;
      stop_after;
      lint;
      specialization_limit;
      robot;
      real;
      probes = [];
      asserts = Off;
      params = [];
    }
  in
  Term.(const make $ format $ dump $ stop_after $ lint $ limit $ robot $ real)

let probed =
  let doc =
    "Show inner signals too, each in a column $(b,probe.NAME): those whose names end in NAME, as \
     $(b,v) or $(b,wallFollow.v); all of a signal function that runs, as $(b,wallFollow); or \
     $(b,all). May be given several times; $(b,list) prints what there is."
  in
  let names = Arg.(value & opt_all (list string) [] & info [ "probe" ] ~docv:"NAME,…" ~doc) in
  let make general names = { general with General.probes = List.concat names } in
  Term.(const make $ general $ names)

(* Of a command; [default]: without the option. *)
let with_asserts ~default ~doc general =
  let all =
    [
      ("off", General.Off);
      ("count", General.Count);
      ("stop", General.Stop);
      ("margin", General.Margin);
    ]
  in
  let asserts = Arg.(value & opt (enum all) default & info [ "asserts" ] ~docv:"HOW" ~doc) in
  Term.(const (fun general asserts -> { general with General.asserts }) $ general $ asserts)

let judging general =
  with_asserts general ~default:General.Count
    ~doc:
      "What is done with the program's assertions: $(b,count) them and tell what became of each, \
       $(b,stop) at the first that is violated, with the robot at rest and exit status 4, or \
       $(b,off). With $(b,margin) what is recorded also says how nearly each held."

let not_judging general =
  with_asserts general ~default:General.Off
    ~doc:
      "With $(b,count), or $(b,stop), the program's assertions are compiled too, and its table for \
       hosts has their verdicts; with $(b,margin) it also says how nearly each held; with \
       $(b,off), as without it, nothing of them is."

(* Of commands that run a program. *)
let with_params general =
  let doc =
    "Run with this value of a parameter that the program declares by $(b,param), as in \
     $(b,kTurn=5[1/m]): an expression as the program could have it, of the parameter's unit. May \
     be given several times."
  in
  let settings = Arg.(value & opt_all string [] & info [ "param" ] ~docv:"NAME=VALUE" ~doc) in
  let make general params = { general with General.params } in
  Term.(const make $ general $ settings)

let time_span =
  let parse text = Result.map_error (fun message -> `Msg message) (Driver.Time_span.parse text) in
  Arg.conv (parse, fun ppf seconds -> Format.fprintf ppf "%gs" seconds)
