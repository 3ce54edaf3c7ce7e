type options = {
  pattern : string option;
  seeds : int option;
  jobs : int option;
  rate : float;
  json : bool;
  junit : string option;
  keep : string;
}

let ( let* ) = Result.bind

(* {1 Finding them} *)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let mentions_tests text =
  let is_test line =
    List.exists (fun prefix -> String.starts_with ~prefix line) [ "test \""; "trial \"" ]
  in
  List.exists is_test (String.split_on_char '\n' text)

(* In a folder all files with tests, in the order of their names. *)
let rec files path =
  if Sys.is_directory path then
    Sys.readdir path |> Array.to_list |> List.sort String.compare
    |> List.filter (fun name -> not (String.starts_with ~prefix:"." name || name = "_build"))
    |> List.map (Filename.concat path)
    |> List.concat_map (fun inner ->
           if Sys.is_directory inner then files inner
           else if Filename.check_suffix inner ".frob" && mentions_tests (read inner) then [ inner ]
           else [])
  else [ path ]

let contains text part =
  let n = String.length part in
  let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
  from 0

(* {1 Running them} *)

type context = {
  general : General.t;
  sources : string list;
  options : options;
  resources : Resources.t;
  jobs : int;
}

(* What is wrong with it has been told. *)
let compiled context general ~entry file =
  let path = ref None in
  let status =
    Commands.shared ~quiet:true general ~entry ~sources:context.sources file (fun _ program ->
        path := Some program;
        Exit_status.ok)
  in
  match !path with
  | Some program -> Ok program
  | None when status = Exit_status.wrong_use -> Error "cannot be run"
  | None -> Error "does not compile"

let measures context ~entry file =
  let found = ref [] in
  let status =
    Commands.accepted ~quiet:true Pipeline.measures context.general context.resources ~entry file
      (fun _ measures ->
        found := measures;
        Exit_status.ok)
  in
  if status = Exit_status.ok then Ok !found else Error "does not compile"

(* The first line of what a host complains of. *)
let complaint (result : Workers.result) =
  match String.split_on_char '\n' (String.trim result.errors) with
  | line :: _ when line <> "" ->
      let prefix = "error: " in
      let n = if String.starts_with ~prefix line then String.length prefix else 0 in
      String.sub line n (String.length line - n)
  | _ -> Printf.sprintf "the host ended with status %d" result.status

let slug text =
  let letter c =
    match c with 'a' .. 'z' | '0' .. '9' -> c | 'A' .. 'Z' -> Char.lowercase_ascii c | _ -> '-'
  in
  String.map letter text

(* For a shell, where it must be. *)
let quoted text =
  let is_plain = function
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '-' | '.' | '/' | '+' -> true
    | _ -> false
  in
  if String.for_all is_plain text then text else Filename.quote text

let robot_option (general : General.t) =
  match general.robot with Some robot -> " --robot " ^ quoted robot | None -> ""

let instants context ~lasts path =
  let channel = open_out path in
  output_string channel "time\n";
  let rec write k =
    let time = float_of_int k /. context.options.rate in
    if time <= lasts +. 1e-9 then begin
      Printf.fprintf channel "%.9f\n" time;
      write (k + 1)
    end
  in
  write 0;
  close_out channel

(* Where what can be looked at of a failed run is put. *)
let kept context (check : Checks.t) ending = Filename.concat context.options.keep
    (slug check.label ^ ending)

let alone context file (check : Checks.t) : Outcome.t =
  let entry = Resolve.Labels.judge check.name in
  let outcome result evidence =
    { Outcome.file; label = check.label; lasts = check.lasts; measures = []; result; evidence }
  in
  let general = { context.general with probes = [ Probes.claims ] } in
  match compiled context general ~entry file with
  | Error reason -> outcome (Error reason) None
  | Ok program -> (
      let times = Filename.concat (Temporary.folder ()) "times.csv" in
      instants context ~lasts:check.lasts times;
      match Workers.run ~jobs:1 [ (context.resources.trace_host, [ program; times ]) ] with
      | [ ({ status = 0; _ } as result) ] ->
          let run = Found.of_trace result.output in
          let evidence () =
            let input = kept context check ".csv" in
            match Output.folder context.options.keep with
            | Error _ -> None
            | Ok () ->
                instants context ~lasts:run.at input;
                let view =
                  Printf.sprintf "frobc trace %s%s --entry %s --input %s --probe all" (quoted file)
                    (robot_option context.general) (quoted entry) (quoted input)
                in
                Some { Outcome.around = []; picture = ""; view }
          in
          let failed = run.fate = Violated || run.fate = Undecided in
          outcome (Ok [ run ]) (if failed then evidence () else None)
      | [ result ] -> outcome (Error (complaint result)) None
      | _ -> outcome (Error "cannot be run") None)

(* Beside the program, or of those that come with frobc. *)
let world context file name =
  let beside = Filename.concat (Filename.dirname file) name in
  let own = Filename.concat context.resources.worlds name in
  if not (Filename.is_relative name) then Ok name
  else if Sys.file_exists beside then Ok beside
  else if Sys.file_exists own then Ok own
  else Error (Printf.sprintf "there is no world `%s` beside the program" name)

(* Parts of the seeds, for so many processes; enough of them that none waits for long. *)
let chunks ~jobs first last =
  let count = last - first + 1 in
  let size = max 1 ((count + (4 * jobs) - 1) / (4 * jobs)) in
  let rec from seed =
    if seed > last then [] else (seed, min last (seed + size - 1)) :: from (seed + size)
  in
  from first

let simulated context file (check : Checks.t) ~world:name ~first ~last : Outcome.t =
  let outcome ?(measures = []) result evidence =
    { Outcome.file; label = check.label; lasts = check.lasts; measures; result; evidence }
  in
  let prepared =
    let* world = world context file name in
    let* general = Commands.for_world context.general context.resources world in
    let entry = Resolve.Labels.judge check.name in
    let* measures = measures context ~entry file in
    let probes = List.map (fun (m : Measures.t) -> m.probe) measures in
    let* judge = compiled context { context.general with probes } ~entry file in
    let* program =
      compiled context { general with probes = [ Probes.claims ] } ~entry:"main" file
    in
    Ok (world, program, judge, measures)
  in
  match prepared with
  | Error reason -> outcome (Error reason) None
  | Ok (world, program, judge, measures) -> (
      let command (first, last) more =
        ( context.resources.simulator,
          [ program; "--world"; world; "--judge"; judge; "--for";
            Printf.sprintf "%.9f" check.lasts; "--rate"; Printf.sprintf "%.9g" context.options.rate;
            "--seed"; string_of_int first; "--last-seed"; string_of_int last ]
          @ more )
      in
      let parts = Array.of_list (chunks ~jobs:context.jobs first last) in
      let progress = Progress.start check.label ~total:(last - first + 1) in
      let ended part =
        let first, last = parts.(part) in
        Progress.add progress (last - first + 1)
      in
      let commands = List.map (fun part -> command part []) (Array.to_list parts) in
      let results = Workers.run ~ended ~jobs:context.jobs commands in
      Progress.finish progress;
      match List.find_opt (fun (r : Workers.result) -> r.status <> 0) results with
      | Some result -> outcome (Error (complaint result)) None
      | None ->
          let runs =
            List.concat_map (fun (r : Workers.result) -> Found.of_trial r.output) results
          in
          let t = outcome ~measures (Ok runs) None in
          let evidence (run : Outcome.run) seed =
            let ending extension = Printf.sprintf "-%d%s" seed extension in
            let record = kept context check (ending ".csv") in
            let picture = kept context check (ending ".png") in
            let output content path = { Output.path; content; asked = "--keep" } in
            let again =
              let* () = Output.folder context.options.keep in
              let* () =
                Output.check ~reads:[ file; world ]
                  [ output Table record; output Picture picture ]
              in
              let more = [ "--record"; record; "--picture"; picture ] in
              match Workers.run ~jobs:1 [ command (seed, seed) more ] with
              | [ { status = 0; _ } ] -> Ok ()
              | _ -> Error "the run could not be recorded"
            in
            let view =
              Printf.sprintf "frobc view %s %s%s --world %s --seed %d  # at %.3f s" (quoted record)
                (quoted file) (robot_option context.general) (quoted world) seed run.at
            in
            match again with
            | Ok () -> { Outcome.around = Found.around (read record); picture; view }
            | Error reason -> { Outcome.around = [ reason ]; picture = ""; view = "" }
          in
          (match Outcome.failures t with
          | ({ seed = Some seed; _ } as run) :: _ -> { t with evidence = Some (evidence run seed) }
          | _ -> t))

let one context file (check : Checks.t) =
  match check.plan with
  | Alone -> alone context file check
  | Simulated { world; first; last } ->
      let last =
        match context.options.seeds with Some count -> first + count - 1 | None -> last
      in
      simulated context file check ~world ~first ~last

(* {1 The command} *)

let tell options outcome =
  if options.json then print_endline (Outcome.json outcome) else Outcome.print outcome

(* Of a file: its outcomes, or the status of a file that is none. *)
let of_file context file =
  let found = ref [] in
  let status =
    Commands.accepted Pipeline.checks context.general context.resources ~entry:"main" file
      (fun _ checks ->
        found := checks;
        Exit_status.ok)
  in
  let is_wanted (check : Checks.t) =
    match context.options.pattern with None -> true | Some part -> contains check.label part
  in
  let outcome check =
    let outcome = one context file check in
    tell context.options outcome;
    outcome
  in
  (status, List.map outcome (List.filter is_wanted !found))

let finish options all =
  if not options.json then Outcome.print_total all;
  match options.junit with
  | None -> Ok ()
  | Some path -> (
      match open_out path with
      | channel ->
          output_string channel (Outcome.junit all);
          close_out channel;
          Ok ()
      | exception Sys_error reason -> Error (Printf.sprintf "cannot write %s" reason))

let run (general : General.t) ~sources (options : options) paths =
  let paths = if paths = [] then [ "." ] else paths in
  match (Resources.find (), List.find_opt (fun path -> not (Sys.file_exists path)) paths) with
  | Error reason, _ -> General.wrong_use reason
  | _, Some path -> General.wrong_use (Printf.sprintf "there is no file %s" path)
  | Ok resources, None -> (
      let jobs = match options.jobs with Some n -> n | None -> Workers.processors () in
      let general = { general with General.asserts = Count } in
      let context = { general; sources; options; resources; jobs } in
      let results = List.map (of_file context) (List.concat_map files paths) in
      let statuses = List.map fst results and all = List.concat_map snd results in
      match (List.find_opt (fun status -> status <> Exit_status.ok) statuses, all) with
      | None, [] ->
          General.wrong_use
            (match options.pattern with
            | Some part -> Printf.sprintf "no test has `%s` in its label" part
            | None -> "there are no tests here: `test \"…\" = …` or `trial \"…\" = …`")
      | Some status, [] -> status
      | rejected, _ -> (
          match finish options all with
          | Error reason -> General.wrong_use reason
          | Ok () ->
              if List.exists Outcome.has_failed all then Exit_status.rejected
              else Option.value rejected ~default:Exit_status.ok))
