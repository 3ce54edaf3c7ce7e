open General

let asks_for_list general = List.mem "list" general.probes

(* Instead of running a program. *)
let print_list general ~entry file =
  let general = { general with probes = []; asserts = Off } in
  let* resources = Resources.find () in
  Compiled.accepted Pipeline.probes general resources ~entry file (fun _ list ->
      print_string list;
      Exit_status.ok)

(* A recording has the verdicts on assertions that somebody watches. *)
let with_claims general =
  if general.asserts = Off || asks_for_list general then general
  else { general with probes = general.probes @ [ Probes.claims ] }
