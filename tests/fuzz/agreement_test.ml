(* The first random programs of seed 1; [make fuzz] goes through more. *)

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

let seed = 1

let agree first () =
  match Batch.failures tools ~seed ~first ~count:Batch.size with
  | [] -> ()
  | failure :: _ -> Alcotest.fail (Batch.describe ~seed failure)

let case k =
  let first = k * Batch.size in
  let name = Printf.sprintf "programs %d to %d" first (first + Batch.size - 1) in
  Alcotest.test_case name `Quick (agree first)

let () =
  Unix.putenv "XDG_CACHE_HOME" (Sys.getcwd ());
  Alcotest.run "random programs" [ ("both engines agree", List.init 10 case) ]
