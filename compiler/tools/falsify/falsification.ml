open Search

let package = "frob.falsify_command"

(* Ctrl-C ends Python without a traceback, even while Python is loading modules. *)
let program =
  Printf.sprintf
    "import signal, sys\n\
     signal.signal(signal.SIGINT, signal.SIG_DFL)\n\
     from %s import main\n\
     sys.exit(main())"
    package

let arguments (general : Common_options.t) ~entry ~sources s file =
  let number = Printf.sprintf "%.17g" in
  (* Passed as a single word, so that a value that starts with `-` is not mistaken for an option. *)
  let option name value = Printf.sprintf "--%s=%s" name value in
  let some name = Option.fold ~none:[] ~some:(fun value -> [ option name value ]) in
  List.concat
    [
      List.map (option "param") s.params;
      List.map (option "input") s.inputs;
      List.map (option "disturbance") s.disturbances;
      some "seeds" s.seeds;
      some "world" s.world;
      [ option "for" (number s.duration); option "rate" (number s.rate) ];
      some "check-rate" (Option.map number s.check_rate);
      [ option "points" (string_of_int s.points) ];
      (if s.linear then [ "--linear" ] else []);
      List.map (option "only") s.only;
      [ option "runs" (string_of_int s.runs); option "seed" (string_of_int s.seed) ];
      [ option "method" s.method_; option "keep" s.keep; option "entry" entry ];
      some "robot" general.robot;
      List.map (option "with") sources;
      [ "--"; file ];
    ]

let missing text =
  Printf.eprintf "error: %s\n" text;
  Exit_status.wrong_use

let run general ~entry ~sources search file =
  if not (Sys.file_exists file) then
    Reporting.wrong_use ("there is no file " ^ Basis.Printable.name file)
  else (
    (* Prevents Python from importing modules from the user's working directory. *)
    Unix.putenv "PYTHONSAFEPATH" "1";
    (* Makes the Python package use this frobc and its hosts, even if others are installed. *)
    if Sys.getenv_opt "FROBC" = None then Unix.putenv "FROBC" Sys.executable_name;
    if Sys.getenv_opt "FROB_HOME" = None then
      Result.iter (fun (r : Resources.t) -> Unix.putenv "FROB_HOME" r.prefix) (Installation.find ());
    let modules = if search.method_ = "cma" then [ "numpy"; "cma" ] else [ "numpy" ] in
    match Extras.python ~modules with
    | None ->
        missing
          "frobc falsify needs Python 3: on Debian, run `sudo apt-get install python3-venv`, then \
           `frobc extras install search`"
    | Some python -> (
        match Process.result python [ "-c"; "import " ^ package ] with
        | Error (Not_found _) | Error (Failed _) ->
            missing
              (Printf.sprintf
                 "frobc falsify needs the Python package frob, but %s cannot load it: reinstall \
                  frobc"
                 (Basis.Printable.name python))
        | Ok _ -> (
            let arguments = arguments general ~entry ~sources search file in
            match Process.become python ("-c" :: program :: arguments) with
            | Not_found _ | Failed _ -> missing "frobc cannot start Python")))
