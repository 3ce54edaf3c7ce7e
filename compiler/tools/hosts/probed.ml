open Common_options
open Reporting

let asks_for_list general = List.mem "list" general.probes

(* Prints the list of inner signals instead of running the program. *)
let print_list general ~entry file =
  let general = { general with probes = []; asserts = Off } in
  let* resources = Installation.find () in
  Compiled.accepted Queries.probes general resources ~entry file (fun _ list ->
      print_string list;
      Exit_status.ok)

(* A recording contains the verdicts of assertions if assertions are enabled. *)
let with_claims general =
  if general.asserts = Off || asks_for_list general then general
  else { general with probes = general.probes @ [ Probes.claims ] }
