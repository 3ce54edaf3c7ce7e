(* {1 Finding tests} *)

let mentions_tests text =
  let is_test line =
    List.exists (fun prefix -> String.starts_with ~prefix line) [ "test \""; "trial \"" ]
  in
  List.exists is_test (String.split_on_char '\n' text)

type file = { path : string; named : bool (* named by the user, instead of found in a folder *) }

(* For a folder, all files in it that contain tests, sorted by name. *)
let rec files ?(named = true) path =
  if Sys.is_directory path then
    Sys.readdir path |> Array.to_list |> List.sort String.compare
    |> List.filter (fun name -> not (String.starts_with ~prefix:"." name || name = "_build"))
    |> List.map (Filename.concat path)
    |> List.concat_map (fun inner ->
           if Sys.is_directory inner then files ~named:false inner
           else
             let is_one =
               Filename.check_suffix inner ".frob" && mentions_tests (Checking.read inner)
             in
             if is_one then [ { path = inner; named = false } ] else [])
  else List.map (fun path -> { path; named }) (Program_file.with_tests [ path ])

(* Removes duplicates: `*.frob` names both a program and its test file. *)
let unique files =
  let add found file =
    if List.exists (fun other -> String.equal other.path file.path) found then found
    else file :: found
  in
  List.rev (List.fold_left add [] files)

let contains text part =
  let n = String.length part in
  let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
  from 0

(* {1 The command} *)

let one (context : Session.t) file (check : Checks.t) =
  match check.plan with
  | Alone -> Alone.run context file check
  | Traced { input; output } -> Golden.run context file check ~input ~output
  | Simulated trial ->
      let last =
        match context.options.seeds with
        | Some count -> trial.first + count - 1
        | None -> trial.last
      in
      Simulated.run context file check { trial with last }

let told = ref 0

let interrupted (options : Session.options) () =
  match !told with
  | 0 -> "no test has finished, so no results were saved; run the same command again to start over"
  | n ->
      Printf.sprintf
        "the results of %s are above, and the failed runs are in %s; run the same command to start \
         again"
        (if n = 1 then "1 test" else Printf.sprintf "%d tests" n)
        options.keep

let tell (options : Session.options) outcome =
  incr told;
  if options.json then print_endline (Results.json outcome) else Results.print outcome

(* The results of the tests in a file. *)
type result = { status : int; ran : Outcome.t list; skipped : Outcome.skipped list }

let skip (options : Session.options) path ({ what; command } : Needs.t) (check : Checks.t) =
  let skipped = { Outcome.path; name = check.label; what; command } in
  if options.json then print_endline (Results.skipped_json skipped)
  else Results.print_skipped skipped;
  skipped

(* A test in a file that was found in a folder may be skipped; a test in a file that the user names
   must run. *)
let of_file (context : Session.t) { path = file; named } =
  let found = ref [] in
  let status =
    Compiled.accepted Queries.checks context.general context.resources ~entry:"main" file
      (fun _ checks ->
        found := checks;
        Exit_status.ok)
  in
  let is_wanted (check : Checks.t) =
    match context.options.pattern with None -> true | Some part -> contains check.label part
  in
  let outcome check =
    let outcome = one context file check in
    let lacking =
      match outcome.result with
      | Error reason when not named -> Needs.library reason
      | Error _ | Ok _ -> None
    in
    match lacking with
    | Some library -> Either.Right (skip context.options file library check)
    | None ->
        tell context.options outcome;
        Either.Left outcome
  in
  let wanted = List.filter is_wanted !found in
  match if named || wanted = [] then None else Needs.of_file context file wanted with
  | None ->
      let ran, skipped = List.partition_map outcome wanted in
      { status; ran; skipped }
  | Some needs -> { status; ran = []; skipped = List.map (skip context.options file needs) wanted }

let finish (options : Session.options) all skipped =
  if not (options.json || all = []) then Results.print_total all ~skipped:(List.length skipped);
  match options.junit with
  | None -> Ok ()
  | Some path -> (
      match open_out path with
      | channel ->
          output_string channel (Results.junit all skipped);
          close_out channel;
          Ok ()
      | exception Sys_error reason -> Error (Printf.sprintf "cannot write %s" reason))

let run (general : Common_options.t) ~sources (options : Session.options) paths =
  let paths = if paths = [] then [ "." ] else paths in
  match (Installation.find (), List.find_opt (fun path -> not (Sys.file_exists path)) paths) with
  | Error reason, _ -> Reporting.wrong_use reason
  | _, Some path ->
      Reporting.wrong_use (Printf.sprintf "there is no file %s" (Basis.Printable.name path))
  | Ok resources, None -> (
      let jobs = match options.jobs with Some n -> n | None -> Workers.processors () in
      let general = { general with Common_options.asserts = Count } in
      let rejected = Hashtbl.create 8 and names = Hashtbl.create 8 in
      let context = { Session.general; sources; options; resources; jobs; rejected; names } in
      let results =
        Interruption.reported (interrupted options) (fun () ->
            List.map (of_file context) (unique (List.concat_map (fun path -> files path) paths)))
      in
      let all = List.concat_map (fun r -> r.ran) results in
      let skipped = List.concat_map (fun r -> r.skipped) results in
      let statuses = List.map (fun r -> r.status) results in
      let rejected = List.find_opt (fun status -> status <> Exit_status.ok) statuses in
      match (rejected, all, skipped) with
      | None, [], [] ->
          Reporting.wrong_use
            (match options.pattern with
            | Some part -> Printf.sprintf "no test has `%s` in its label" part
            | None -> "there are no tests here: write `test \"…\" = …` or `trial \"…\" = …`")
      | Some status, [], [] -> status
      | _, _, _ -> (
          match finish options all skipped with
          | Error reason -> Reporting.wrong_use reason
          | Ok () when List.exists Results.has_failed all -> Exit_status.rejected
          | Ok () when all = [] && rejected = None ->
              Reporting.wrong_use "no test was run; see above for how to run the skipped tests"
          | Ok () -> Option.value rejected ~default:Exit_status.ok))
