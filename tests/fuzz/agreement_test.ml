(* The first random programs of each bias; [make fuzz] goes through more. *)

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

let first = 0

let agree seed () =
  match Batch.failures tools ~seed ~first ~count:Batch.size with
  | [] -> ()
  | failure :: _ -> Alcotest.fail (Batch.describe ~seed failure)

let case i =
  let seed = i + 1 in
  let name = Printf.sprintf "programs %d to %d of seed %d" first (first + Batch.size - 1) seed in
  Alcotest.test_case name `Quick (agree seed)

let () =
  Unix.putenv "XDG_CACHE_HOME" (Sys.getcwd ());
  Alcotest.run "random programs" [ ("both engines agree", List.init Bias.count case) ]
