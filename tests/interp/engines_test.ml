(* Each program here, and the examples, through the interpreter and through C:
   the same bytes for the same input. Once as `frobc trace` compiles, once with
   the C compiler's sanitizers, which stop what is out of bounds or undefined. *)

open Fuzz

let root = "../.."
let ( / ) = Filename.concat

type c_compiler = Usual | Sanitized

let tools compiler =
  {
    Engines.library = root / "stdlib";
    headers = root / "runtime" / "include";
    runtime = root / "runtime" / "libfrob.a";
    trace_host =
      (match compiler with
      | Usual -> root / "runtime" / "frob-trace"
      | Sanitized -> "." / "sanitized-trace");
    folder = Filename.current_dir_name;
  }

let agree compiler file () =
  Unix.putenv "CC" (match compiler with Usual -> "gcc" | Sanitized -> "." / "sanitized-cc");
  let random = Random.State.make [| 2001 |] in
  match Engines.compare (tools compiler) random ~rows:200 ~entry:"main" file with
  | Agree -> ()
  | (Rejected _ | Failed _ | Differ _) as outcome -> Alcotest.fail (Engines.describe outcome)

let case compiler file =
  let words = String.concat " " (String.split_on_char '_' (Filename.basename file)) in
  Alcotest.test_case (Filename.remove_extension words) `Quick (agree compiler file)

let programs =
  Sys.readdir Filename.current_dir_name
  |> Array.to_list
  |> List.filter (fun file -> Filename.check_suffix file ".frob")
  |> List.sort String.compare

let examples =
  List.map (fun name -> root / "examples" / name / (name ^ ".frob")) [ "heading_hold"; "wall_follow" ]

let () =
  Unix.putenv "XDG_CACHE_HOME" (Sys.getcwd ());
  (* What stays in memory until the host ends is not lost. *)
  Unix.putenv "ASAN_OPTIONS" "detect_leaks=0";
  Alcotest.run "both engines"
    [
      ("constructs", List.map (case Usual) programs);
      ("examples", List.map (case Usual) examples);
      ("under the sanitizers", List.map (case Sanitized) (programs @ examples));
    ]
