open Basis
open Basis.Let_syntax.Result
open Setup

let most_runs = 10_000_000
let refuse text = Error (Reporting.wrong_use text)

let refuse_at (p : 'a Plan.placed) format =
  Printf.ksprintf (fun text -> refuse (p.place ^ ": " ^ text)) format

let rec each f = function
  | [] -> Ok []
  | x :: others ->
      let* y = f x in
      Result.map (fun ys -> y :: ys) (each f others)

let beside plan name =
  if Filename.is_relative name && Filename.dirname plan <> "." then
    Filename.concat (Filename.dirname plan) name
  else name

(* {1 The trial} *)

(* The trials of a program and its test file, each with the file that contains it. *)
let rec trials (context : Session.t) = function
  | [] -> Ok []
  | file :: others ->
      let* own = trials_in context file in
      let* others = trials context others in
      Ok (List.map (fun trial -> (file, trial)) own @ others)

and trials_in context file =
  let found = ref [] in
  let status =
    Compiled.accepted Queries.checks context.general context.resources ~entry:"main" file
      (fun _ checks ->
        found := checks;
        Exit_status.ok)
  in
  let trial (check : Checks.t) =
    match check.plan with Simulated trial -> Some (check, trial) | Alone | Traced _ -> None
  in
  if status = Exit_status.ok then Ok (List.filter_map trial !found) else Error status

let labels trials =
  Enumeration.all (List.map (fun (_, ((c : Checks.t), _)) -> Printf.sprintf "`%s`" c.label) trials)

let trial_of (plan : Plan.t) file trials =
  match (plan.trial, trials) with
  | _, [] ->
      refuse_at plan.program
        "%s has no trial, but a sweep needs one to judge and measure the runs: write `trial \"…\" \
         = Trial { … }`"
        file
  | None, [ only ] -> Ok only
  | None, _ ->
      refuse_at plan.program "the program has several trials; choose one with `trial = \"…\"`: %s"
        (labels trials)
  | Some wanted, _ -> (
      let is_it (_, ((check : Checks.t), _)) = String.equal check.label wanted.value in
      match List.find_opt is_it trials with
      | Some trial -> Ok trial
      | None -> refuse_at wanted "%s has no trial `%s`; it has %s" file wanted.value (labels trials)
      )

(* {1 Parameters} *)

let value (context : Session.t) file (p : _ Plan.placed) ~name text =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let request = Request.make ~options:context.general ~library:context.resources.library file in
  match Queries.params sink sources { request with settings = [ { name; text } ] } with
  | Some [ set ] -> Ok set
  | Some _ | None ->
      Printf.eprintf "error: %s: this is not a value of the parameter `%s`\n"
        (Printable.name p.place) (Printable.name name);
      Reporting.print_diagnostics Text sources sink;
      Error Exit_status.wrong_use

(* The value after `name=`, for hosts. *)
let given (set : Params.set) =
  let at = String.index set.setting '=' + 1 in
  String.sub set.setting at (String.length set.setting - at)

let axis context units file (p : (string * Plan.variation) Plan.placed) =
  let name, variation = p.value in
  let value = value context file p ~name in
  match variation with
  | Values texts ->
      let* sets = each value texts in
      Ok { Points.name; unit_ = units name; along = Each (List.map given sets) }
  | Range { low; high; steps } -> (
      let* low_set = value low in
      let* high_set = value high in
      let between low high ~whole =
        if low < high then
          Ok { Points.name; unit_ = units name; along = Between { low; high; steps; whole } }
        else
          refuse_at p "the range of `%s` ends at %s, which is not greater than its start, %s" name
            (given high_set) (given low_set)
      in
      match (low_set.value, high_set.value) with
      | Float low, Float high when Float.is_finite low && Float.is_finite high ->
          between low high ~whole:false
      | Float _, Float _ -> refuse_at p "the range of `%s` must be finite" name
      | Int low, Int high -> between (Int32.to_float low) (Int32.to_float high) ~whole:true
      | _ -> refuse_at p "`%s` is a Bool and has no range: write the list [true, false]" name)

(* {1 Places} *)

(* A user-defined robot is in a file next to the plan. *)
let robots (plan : Plan.t) path (general : Common_options.t) =
  let known (r : string Plan.placed) =
    let robot = if Filename.check_suffix r.value ".frob" then beside path r.value else r.value in
    match Robots.known (Some robot) with Ok _ -> Ok robot | Error text -> refuse_at r "%s" text
  in
  match (plan.robots, general.robot) with
  | [], robot -> Ok [ Option.value robot ~default:"" ]
  | all, None -> each known all
  | first :: _, Some _ -> refuse_at first "remove `robots` here, or the option --robot"

let worlds context (plan : Plan.t) file (trial : Checks.trial) =
  let path where name =
    match Simulated.world_of context file name with
    | Ok path -> Ok (name, path)
    | Error text -> where text
  in
  match plan.worlds with
  | [] -> Result.map (fun one -> [ one ]) (path refuse trial.world)
  | worlds ->
      each (fun (w : string Plan.placed) -> path (fun text -> refuse_at w "%s" text) w.value) worlds

let digest_of (context : Session.t) general ~entry file =
  let text = ref "" in
  ignore
    (Compiled.to_c ~quiet:true general context.resources ~entry file (fun files ->
         text := files.source ^ files.header ^ Option.value files.host_table ~default:"";
         Exit_status.ok));
  Digest.string (String.concat "" (!text :: List.map Digest.file context.sources))

(* The digest includes the files that the world refers to: the files in its folder whose names
   appear in it in quotes. *)
let digest_of_world path =
  let text = Checking.read path in
  let quoted = List.concat_map (String.split_on_char '\'') (String.split_on_char '"' text) in
  let contents name =
    let file = Filename.concat (Filename.dirname path) name in
    if Sys.file_exists file && not (Sys.is_directory file) then Some (Digest.file file) else None
  in
  Digest.string (String.concat "" (text :: List.filter_map contents quoted))

type subject = {
  file : string;  (** the program's source file *)
  judging_file : string;  (** the file of the trial, which may be a test file *)
  check : Checks.t;
  measures : Measures.t list;
}

let place (context : Session.t) subject (world, path) robot =
  let { file; judging_file; check; measures } = subject in
  let general = context.general in
  let general = if robot = "" then general else { general with robot = Some robot } in
  let* general =
    match Where.for_world general context.resources path with
    | Ok general -> Ok general
    | Error text -> refuse text
  in
  let entry = Resolve.Labels.judge check.name in
  let probes = List.map (fun (m : Measures.t) -> m.probe) measures in
  let judging = { context.general with probes } in
  let driving = { general with probes = [ Probes.claims ] } in
  let compiled general ~entry file =
    Result.map_error (fun _ -> Exit_status.rejected) (Checking.compiled context general ~entry file)
  in
  let* judge = compiled judging ~entry judging_file in
  let* program = compiled driving ~entry:"main" file in
  let digest =
    Digest.string
      (String.concat ""
         [
           digest_of context driving ~entry:"main" file;
           digest_of context judging ~entry judging_file;
           digest_of_world path;
           Digest.file context.resources.simulator;
         ])
  in
  Ok { world; path; robot = Option.value general.robot ~default:""; program; judge; digest }

(* {1 Trying each world and robot} *)

(* Simulates one instant of the first run for each world and robot. *)
let tried (context : Session.t) (t : t) =
  let settings =
    List.mapi (fun k (axis : Points.axis) -> axis.name ^ "=" ^ t.points.(0).(k)) t.axes
  in
  let list = Filename.concat (Temporary.folder ()) "first" in
  let line = String.concat "\t" ("first" :: string_of_int t.first :: settings) ^ "\n" in
  let* () = Result.map_error Reporting.wrong_use (Output.write [ (list, line) ]) in
  let one place =
    let arguments =
      [ place.program; "--world"; place.path; "--judge"; place.judge; "--for"; "0"; "--runs"; list ]
    in
    match Workers.run ~jobs:1 [ (context.resources.simulator, arguments) ] with
    | [ { status = 0; _ } ] -> Ok ()
    | [ result ] -> refuse (Checking.complaint result)
    | _ -> refuse "frobc cannot start the simulator"
  in
  Result.map (fun _ -> t) (each one (Array.to_list t.places))

let units_of context file names =
  if names = [] then Ok (fun _ -> "")
  else
    let sink = Diagnostic.sink () and sources = Source.create () in
    let request =
      Request.make ~options:context.Session.general ~library:context.resources.library file
    in
    match Queries.units_of_params sink sources request with
    | Some units -> Ok (fun name -> Option.value (List.assoc_opt name units) ~default:"")
    | None ->
        Reporting.print_diagnostics Text sources sink;
        Error (Reporting.status sink)

let complete context (plan : Plan.t) path =
  let file = beside path plan.program.value in
  let* () =
    if Sys.file_exists file then Ok ()
    else refuse_at plan.program "there is no file %s" (Printable.name file)
  in
  let file = Resolve.Test_file.program_or_self file in
  let* trials = trials context (Program_file.with_tests [ file ]) in
  let* judging_file, (check, trial) = trial_of plan file trials in
  let* units = units_of context file plan.params in
  let* axes = each (axis context units file) plan.params in
  let first, last = Option.value plan.seeds ~default:(trial.first, trial.last) in
  let* robots = robots plan path context.general in
  let* worlds = worlds context plan file trial in
  let total =
    List.length worlds * List.length robots
    * (last - first + 1)
    * Points.count ~sampling:plan.sampling ~points:plan.points axes
  in
  let* () =
    if total <= most_runs then Ok ()
    else
      refuse
        (Printf.sprintf
           "%s: this plan has %d runs, but a sweep can have at most %d: use fewer steps or seeds"
           path total most_runs)
  in
  let points =
    Points.all ~sampling:plan.sampling ~points:plan.points ~seed:plan.sampling_seed axes
    |> Array.of_list
  in
  let* measures =
    Result.map_error
      (fun _ -> Exit_status.rejected)
      (Checking.measures context ~entry:(Resolve.Labels.judge check.name) judging_file)
  in
  let subject = { file; judging_file; check; measures } in
  let* places = each (fun world -> each (place context subject world) robots) worlds in
  let lasts = Option.value plan.lasts ~default:check.lasts in
  let rate = Option.value plan.rate ~default:50. in
  tried context
    {
      plan;
      label = check.label;
      lasts;
      rate;
      first;
      last;
      places = Array.of_list (List.concat places);
      axes;
      points;
      measures;
    }

let of_plan general ~sources path =
  let* resources = Result.map_error Reporting.wrong_use (Installation.find ()) in
  let* () =
    if Sys.file_exists path then Ok ()
    else refuse (Printf.sprintf "there is no file %s" (Printable.name path))
  in
  let* plan =
    Result.map_error
      (fun text ->
        prerr_string text;
        Exit_status.wrong_use)
      (Plan_file.read resources path)
  in
  let general = { general with Common_options.asserts = Count } in
  complete (Checking.alone general ~sources resources) plan path
