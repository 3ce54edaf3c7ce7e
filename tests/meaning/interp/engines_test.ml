(* Runs each program here and the examples in the interpreter and as C; both must write the same
   bytes for the same input. The C is compiled once with tcc, and once by an optimizing compiler
   with sanitizers, which stop at out-of-bounds accesses and undefined behaviour. The input is
   random; if there is a recording next to a program, as the fuzzer prints it, it is used too. *)

open Fuzz

let root = "../../.."
let ( / ) = Filename.concat

let tools ~probed real =
  {
    Engines.library = root / "stdlib";
    runtime = root / "runtime";
    folder = Filename.current_dir_name;
    real;
    probed;
  }

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

(* The recorded input on which a program once failed. *)
let recorded subject file =
  let path = Filename.remove_extension file ^ ".csv" in
  if not (Sys.file_exists path) then []
  else
    match Engines.read_recording subject (read path) with
    | Ok recording -> [ recording ]
    | Error text -> Alcotest.fail (path ^ ": " ^ text)

let agree ?(real = Basis.Real.Double) ?(probed = false) engine (file, robot) () =
  let tools = tools ~probed real in
  let random = Random.State.make [| 2001 |] in
  let outcome =
    match Engines.load ?robot tools ~entry:"main" file with
    | Error outcome -> outcome
    | Ok subject ->
        let random = Engines.recordings random ~rows:200 subject in
        Engines.judge tools [ engine ] subject (recorded subject file @ random)
  in
  match outcome with
  | Agree -> ()
  | Rejected _ | Failed _ | Differ _ -> Alcotest.fail (Engines.describe outcome)

let case ?real ?probed engine ((file, _) as program) =
  let words = String.concat " " (String.split_on_char '_' (Filename.basename file)) in
  Alcotest.test_case (Filename.remove_extension words) `Quick (agree ?real ?probed engine program)

let programs =
  Sys.readdir Filename.current_dir_name
  |> Array.to_list
  |> List.filter (fun file -> Filename.check_suffix file ".frob")
  |> List.sort String.compare
  |> List.map (fun file -> (file, None))

let robot name =
  match Build.Robots.known (Some name) with Ok robot -> robot | Error reason -> failwith reason

(* The examples without C code of their own. *)
let examples =
  let example ?robot name = (root / "examples" / name / (name ^ ".frob"), robot) in
  let for_pioneer =
    [ "bug"; "corridor"; "dock"; "explore"; "heading_hold"; "patrol"; "subsumption"; "wall_follow" ]
  in
  List.map (fun name -> example name) for_pioneer
  @ [
      example ?robot:(robot "create") "line_follow";
      example ?robot:(robot "pioneer") "safe_stick";
      example ?robot:(robot "create") "vfh";
      example ?robot:(robot "pioneer") "gyro_bias";
      example ?robot:(robot (root / "examples/light_seek/Moth.frob")) "light_seek";
    ]

let () =
  (* Memory that the host keeps until it exits is not a leak. *)
  Unix.putenv "ASAN_OPTIONS" "detect_leaks=0";
  Alcotest.run "both engines"
    [
      ("constructs", List.map (case Tcc) programs);
      ("examples", List.map (case Tcc) examples);
      ("under the sanitizers", List.map (case (Sanitized Gcc)) (programs @ examples));
      ("in single precision", List.map (case ~real:Single Tcc) (programs @ examples));
      ("with probes", List.map (case ~probed:true Tcc) (programs @ examples));
      ("with probes, in single precision", List.map (case ~real:Single ~probed:true Tcc) examples);
    ]
