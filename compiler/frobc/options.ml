open Cmdliner
module Common_options = Build.Common_options
module Stage = Build.Stage

let exits =
  [
    Cmd.Exit.info Build.Exit_status.ok ~doc:"done.";
    Cmd.Exit.info Build.Exit_status.rejected
      ~doc:"the program was rejected; diagnostics are on standard error.";
    Cmd.Exit.info Build.Exit_status.wrong_use
      ~doc:"wrong usage, a missing file, unreadable input, or a missing tool.";
    Cmd.Exit.info Build.Exit_status.bug ~doc:"a bug in frobc.";
    Cmd.Exit.info Build.Exit_status.fault
      ~doc:"the run ended with a fault: robot lost, watchdog, collision limit, assertion violated.";
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
    "A C or C++ file to compile with a program that calls foreign code, a header that it may \
     include, or a compiled file to link. Can be repeated. C code can do anything on your \
     computer: use only files that you trust."
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

let robot_names = String.concat ", " (List.map (Printf.sprintf "$(b,%s)") Build.Robots.names)

let real =
  let doc =
    "The C type of $(b,Float): $(b,double), or $(b,float) (single precision) for microcontrollers \
     without double-precision arithmetic."
  in
  let precisions = [ ("double", Basis.Real.Double); ("float", Single) ] in
  Arg.(value & opt (enum precisions) Basis.Real.Double & info [ "real" ] ~docv:"TYPE" ~doc)

let general =
  let format =
    let doc =
      "The format of diagnostics and reports: $(b,text), or $(b,json) with one object per line. \
       Text shows the first 100 errors and the first 100 warnings; JSON shows the first 1000 of \
       each. If there are more, the last JSON object has a field $(b,left_out) with the number of \
       $(b,errors) and of $(b,warnings) that are not shown."
    in
    Arg.(
      value
      & opt
          (enum [ ("text", Common_options.Text); ("json", Common_options.Json) ])
          Common_options.Text
      & info [ "format" ] ~docv:"FORMAT" ~doc)
  in
  let dump =
    let doc = "Print the program after this stage of the compiler: " ^ stages_doc ^ "." in
    Arg.(value & opt (some stage) None & info [ "dump" ] ~docv:"STAGE" ~doc)
  in
  let stop_after =
    let doc = "Stop after this stage of the compiler; see $(b,--dump) for the names." in
    Arg.(value & opt (some stage) None & info [ "stop-after" ] ~docv:"STAGE" ~doc)
  in
  let lint =
    let doc = "Check the invariants of the compiler after each stage." in
    Arg.(value & flag & info [ "lint" ] ~doc)
  in
  let limit =
    let doc =
      "Maximum number of specialized copies of one definition; a program with more is rejected."
    in
    let default = Common_options.default.specialization_limit in
    Arg.(value & opt int default & info [ "specialization-limit" ] ~docv:"N" ~doc)
  in
  let robot =
    let doc =
      "The robot to compile for: " ^ robot_names
      ^ ", or the module file of your own robot, as in $(b,Rover.frob)."
    in
    Arg.(value & opt (some string) None & info [ "robot" ] ~docv:"ROBOT" ~doc)
  in
  let make format dump stop_after lint specialization_limit robot real =
    {
      Common_options.format;
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
    "Also show inner signals, each in a column $(b,probe.NAME). $(i,NAME) selects the signals \
     whose names end in NAME, such as $(b,v) or $(b,wallFollow.v), all signals of a signal \
     function, such as $(b,wallFollow), or $(b,all). Can be repeated; $(b,list) lists the inner \
     signals."
  in
  let names = Arg.(value & opt_all (list string) [] & info [ "probe" ] ~docv:"NAME,…" ~doc) in
  let make general names = { general with Common_options.probes = List.concat names } in
  Term.(const make $ general $ names)

(* Adds the option [--asserts], whose default and description differ between commands. *)
let with_asserts ~default ~doc general =
  let all =
    [
      ("off", Common_options.Off);
      ("count", Common_options.Count);
      ("stop", Common_options.Stop);
      ("margin", Common_options.Margin);
    ]
  in
  let asserts = Arg.(value & opt (enum all) default & info [ "asserts" ] ~docv:"HOW" ~doc) in
  Term.(const (fun general asserts -> { general with Common_options.asserts }) $ general $ asserts)

let judging general =
  with_asserts general ~default:Common_options.Count
    ~doc:
      "What to do with the program's assertions: $(b,count) checks them and reports results, \
       $(b,stop) stops the robot at the first violation and exits with status 4, and $(b,off) \
       ignores them. $(b,margin) also records the margin by which each assertion holds."

let not_judging general =
  with_asserts general ~default:Common_options.Off
    ~doc:
      "With $(b,count) or $(b,stop), the generated C checks the program's assertions, and its \
       table for hosts contains their results. With $(b,margin), the table also contains the \
       margin by which each assertion holds. With $(b,off), the default, the generated C does not \
       check them."

(* Adds the option [--param], for commands that run a program. *)
let with_params general =
  let doc =
    "Run with this value of a parameter that the program declares with $(b,param), as in \
     $(b,kTurn=5[1/m]). The value is a Frob expression with the parameter's unit. Can be repeated."
  in
  let settings = Arg.(value & opt_all string [] & info [ "param" ] ~docv:"NAME=VALUE" ~doc) in
  let make general params = { general with Common_options.params } in
  Term.(const make $ general $ settings)

let time_span =
  let parse text = Result.map_error (fun message -> `Msg message) (Build.Time_span.parse text) in
  Arg.conv (parse, fun ppf seconds -> Format.fprintf ppf "%gs" seconds)

(* Options of commands that can read recordings made by other programs. *)
let dialect =
  let separator =
    let parse text =
      match text with
      | "tab" | "\t" -> Ok '\t'
      | _ when String.length text = 1 && String.contains ",;|: ^~#&/" text.[0] -> Ok text.[0]
      | _ ->
          Error
            (`Msg (Printf.sprintf "`%s` is neither `tab` nor a single character such as `;`" text))
    in
    let print ppf = function
      | '\t' -> Format.pp_print_string ppf "tab"
      | c -> Format.pp_print_char ppf c
    in
    let doc =
      "The character that separates the cells of the recording, such as $(b,';'), or $(b,tab). The \
       default is a comma."
    in
    Arg.(value & opt (conv (parse, print)) ',' & info [ "separator" ] ~docv:"CHARACTER" ~doc)
  in
  let decimal_comma =
    let doc = "Read numbers with a decimal comma, such as $(b,0,5)." in
    Arg.(value & flag & info [ "decimal-comma" ] ~doc)
  in
  let time_column =
    let doc =
      "The column of the recording that contains the times. The default is the first column, \
       $(b,time)."
    in
    Arg.(value & opt (some string) None & info [ "time-column" ] ~docv:"COLUMN" ~doc)
  in
  let columns =
    let parse text =
      match String.index_opt text '=' with
      | Some i when i > 0 && i < String.length text - 1 ->
          Ok (String.sub text 0 i, String.sub text (i + 1) (String.length text - i - 1))
      | Some _ | None ->
          Error
            (`Msg
               (Printf.sprintf
                  "`%s` does not have the form NAME=COLUMN: write, for example, \
                   in.speed=wheel_speed"
                  text))
    in
    let print ppf (name, column) = Format.fprintf ppf "%s=%s" name column in
    let column = Arg.conv (parse, print) in
    let doc =
      "Read $(i,NAME), a column of the program such as $(b,in.speed), from the recording's \
       $(i,COLUMN). Can be repeated. With this option or $(b,--time-column), columns that the \
       program does not have are ignored."
    in
    Arg.(value & opt_all column [] & info [ "column" ] ~docv:"NAME=COLUMN" ~doc)
  in
  let make separator decimal_comma time_column columns =
    { Interp.Dialect.separator; decimal_comma; time_column; columns }
  in
  Term.(const make $ separator $ decimal_comma $ time_column $ columns)

let some_string name ~docv ~doc = Arg.(value & opt (some string) None & info [ name ] ~docv ~doc)

let jobs =
  let doc = "Number of parallel processes. The default is the number of processors." in
  Arg.(value & opt (some int) None & info [ "j"; "jobs" ] ~docv:"N" ~doc)

let positive name = function
  | Some n when n < 1 -> Error (Printf.sprintf "%s must be at least 1" name)
  | _ -> Ok ()
