(* Each program here, and the examples, through the interpreter and through C:
   the same bytes for the same input. *)

open Fuzz

let root = "../.."
let ( / ) = Filename.concat

let tools =
  {
    Engines.library = root / "stdlib";
    headers = root / "runtime" / "include";
    trace_host = root / "runtime" / "frob-trace";
    folder = Filename.current_dir_name;
  }

let agree file () =
  let random = Random.State.make [| 2001 |] in
  match Engines.compare tools random ~rows:200 ~entry:"main" file with
  | Agree -> ()
  | (Rejected _ | Failed _ | Differ _) as outcome -> Alcotest.fail (Engines.describe outcome)

let case file =
  let words = String.concat " " (String.split_on_char '_' (Filename.basename file)) in
  Alcotest.test_case (Filename.remove_extension words) `Quick (agree file)

let programs =
  Sys.readdir Filename.current_dir_name
  |> Array.to_list
  |> List.filter (fun file -> Filename.check_suffix file ".frob")
  |> List.sort String.compare

let examples =
  List.map (fun name -> root / "examples" / name / (name ^ ".frob")) [ "heading_hold"; "wall_follow" ]

let () =
  Unix.putenv "XDG_CACHE_HOME" (Sys.getcwd ());
  Alcotest.run "both engines"
    [ ("constructs", List.map case programs); ("examples", List.map case examples) ]
