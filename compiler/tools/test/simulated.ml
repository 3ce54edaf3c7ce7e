open Checking
open Session
open Basis.Let_syntax.Result

let world_of context file name = Where.find context.resources [ Beside file ] name

(* Splits the seeds into ranges, several for each process, so that the processes finish at about the
   same time. *)
let chunks ~jobs first last =
  let count = last - first + 1 in
  let size = max 1 ((count + (4 * jobs) - 1) / (4 * jobs)) in
  let rec from seed =
    if seed > last then [] else (seed, min last (seed + size - 1)) :: from (seed + size)
  in
  from first

type prepared = {
  context : Session.t;
  file : string; (* the program's file *)
  check : Checks.t;
  world : string; (* its path *)
  program : string;
  judge : string;
  measures : Measures.t list;
}

let prepared context file (check : Checks.t) world =
  let* world = world_of context file world in
  let* general = Where.for_world context.general context.resources world in
  let entry = Resolve.Labels.judge check.name in
  let* measures = measures context ~entry file in
  let probes = List.map (fun (m : Measures.t) -> m.probe) measures in
  let* judge = compiled context { context.general with probes } ~entry file in
  let general = { general with probes = [ Probes.claims ] } in
  let main = Resolve.Test_file.program_or_self file in
  let* program = compiled context general ~entry:"main" main in
  Ok { context; file = main; check; world; program; judge; measures }

let command p ?(world = p.world) (first, last) more =
  let { Session.resources; options; _ } = p.context in
  ( resources.simulator,
    [
      p.program;
      "--world";
      world;
      "--judge";
      p.judge;
      "--for";
      Printf.sprintf "%.9f" p.check.lasts;
      "--rate";
      Printf.sprintf "%.9g" options.rate;
      "--seed";
      string_of_int first;
      "--last-seed";
      string_of_int last;
    ]
    @ more )

(* The command that repeats the run with one seed. *)
let run_again p ~world seed =
  let { Session.options; _ } = p.context in
  let rate = if options.rate = 50. then "" else Printf.sprintf " --rate %.9g" options.rate in
  Printf.sprintf "frobc run %s%s --world %s --seed %d --for %s%s" (Basis.Printable.path p.file)
    (program_words p.context) (Basis.Printable.path world) seed (Time_span.print p.check.lasts) rate

(* {1 Running all seeds} *)

(* Explains why the simulator was killed. The simulator writes a line after each run, so the number
   of lines identifies the interrupted run. *)
let ended_by p ~first (result : Workers.result) =
  match Signals.name result.status with
  | Some signal when String.trim result.errors = "" ->
      let seed = first + List.length (Found.of_trial result.output) in
      Printf.sprintf "%s ended the simulator during the run with seed %d; `%s` repeats that run"
        signal seed (run_again p ~world:p.world seed)
  | Some _ | None -> complaint result

let runs p progress first last =
  let jobs = p.context.jobs in
  let parts = Array.of_list (chunks ~jobs first last) in
  let ended part =
    let first, last = parts.(part) in
    Progress.add progress (last - first + 1)
  in
  let parts = Array.to_list parts in
  let results = Workers.run ~ended ~jobs (List.map (fun part -> command p part []) parts) in
  let failed ((_, result) : _ * Workers.result) = result.status <> 0 in
  match List.find_opt failed (List.combine parts results) with
  | Some ((first, _), result) -> Error (ended_by p ~first result)
  | None -> Ok (List.concat_map (fun (r : Workers.result) -> Found.of_trial r.output) results)

(* Performs runs in batches until the result is decided. Discards the runs after the deciding one,
   so that the outcome does not depend on the batch size. *)
let rec until_decided p progress ~decided ~first ~last known =
  match decided known with
  | Some count -> Ok (List.filteri (fun k _ -> k < count) known)
  | None when first > last -> Ok known
  | None ->
      let upto = min last (first + max 32 (List.length known) - 1) in
      let* more = runs p progress first upto in
      until_decided p progress ~decided ~first:(upto + 1) ~last (known @ more)

(* {1 Repeating a failed run} *)

let output content path = { Output.path; content; asked = "--keep" }

(* Runs the program with one seed, with additional options for the host. *)
let single p ~world seed more =
  match Workers.run ~jobs:1 [ command p ~world (seed, seed) more ] with
  | [ { status = 0; output; _ } ] -> (
      match Found.of_trial output with [ run ] -> Some run | _ -> None)
  | _ -> None

(* Whether these files can be written to the user's folder. *)
let may_write p ~world outputs =
  let* () = Output.folder p.context.options.keep in
  Output.check ~reads:[ p.file; world ] outputs

(* Repeats the run, and saves a recording and a picture of it at this path. The last result says why
   a file could not be saved. If the recording cannot be saved, the run is recorded in a temporary
   folder, and the command shown to the user repeats the run. *)
let looked_at p (run : Outcome.run) ~world ~path seed =
  let record = path ^ ".csv" and picture = path ^ ".png" in
  let recorded = may_write p ~world [ output Table record ] in
  let drawn = may_write p ~world [ output Picture picture ] in
  let attempt ~record ~picture =
    let picture = Option.fold ~none:[] ~some:(fun path -> [ "--picture"; path ]) picture in
    Option.map
      (fun (again : Outcome.run) -> (again, Found.around (read record)))
      (single p ~world seed ([ "--record"; record ] @ picture))
  in
  let aside () =
    let again = attempt ~record:(Filename.concat (Temporary.folder ()) "run.csv") ~picture:None in
    let again, around = Option.value again ~default:(run, []) in
    (again, { Outcome.around; picture = ""; view = run_again p ~world seed })
  in
  let notes = List.filter_map (function Ok () -> None | Error note -> Some note) in
  match recorded with
  | Error _ -> (
      let again, look = aside () in
      let notes = String.concat "; " (List.sort_uniq compare (notes [ recorded; drawn ])) in
      match drawn with
      | Ok () when single p ~world seed [ "--picture"; picture ] <> None ->
          (again, { look with picture }, notes)
      | Ok () | Error _ -> (again, look, notes))
  | Ok () -> (
      match attempt ~record ~picture:(if Result.is_ok drawn then Some picture else None) with
      | None ->
          let again, look = aside () in
          (again, look, "frobc could not record the run in " ^ p.context.options.keep)
      | Some (again, around) ->
          let view =
            Printf.sprintf "frobc view %s %s%s --world %s --seed %d --at %s"
              (Basis.Printable.path record) (Basis.Printable.path p.file) (program_words p.context)
              (Basis.Printable.path world) seed (Time_span.print again.at)
          in
          let picture = if Result.is_ok drawn then picture else "" in
          (again, { Outcome.around; picture; view }, String.concat "; " (notes [ drawn ])))

(* Splits the disturbances into those that can be removed and those that must stay, because without
   them the run does not fail in the same way. Returns [None] if all must stay, or if the world
   names files, because a copy of it in another folder would not find them. *)
let left_out p (run : Outcome.run) seed text =
  let all = Disturbances.of_world text in
  let trial = Filename.concat (Temporary.folder ()) "world.toml" in
  let still_fails left_out =
    let channel = open_out_bin trial in
    output_string channel (Disturbances.without left_out text);
    close_out channel;
    match single p ~world:trial seed [] with
    | Some again -> again.fate = run.fate && String.equal again.by run.by
    | None -> false
  in
  if all = [] || Disturbances.names_files text then None
  else
    let needed = Disturbances.needed ~still_fails all in
    match List.filter (fun t -> not (List.mem t needed)) all with
    | [] -> None
    | left_out -> Some (left_out, List.map Disturbances.name needed)

(* The second result says why files could not be saved; it is empty if all were saved. *)
let simpler p run seed : Outcome.simpler option * string =
  let text = read p.world in
  match left_out p run seed text with
  | None -> (None, "")
  | Some (left_out, needs) -> (
      let path = kept p.context p.file p.check (Printf.sprintf "-%d-simpler" seed) in
      let world = path ^ ".toml" in
      let head =
        Printf.sprintf
          "# written by frobc: %s, reduced to the disturbances without which the run does not fail\n"
          (Filename.basename p.world)
      in
      let written =
        let* () = may_write p ~world:p.world [ output World world ] in
        Output.write [ (world, head ^ Disturbances.without left_out text) ]
      in
      match written with
      | Error note -> (None, note)
      | Ok () ->
          let again, seen, note = looked_at p run ~world ~path seed in
          (Some { Outcome.needs; world; again; seen }, note))

let evidence p (run : Outcome.run) seed : Outcome.evidence =
  let path = kept p.context p.file p.check (Printf.sprintf "-%d" seed) in
  let _, look, note = looked_at p run ~world:p.world ~path seed in
  let simpler, another = simpler p run seed in
  let notes = List.sort_uniq String.compare (List.filter (( <> ) "") [ note; another ]) in
  { run; look; simpler; note = String.concat "; " notes }

(* {1 The trial} *)

(* The run that failed earliest. *)
let shortest = function
  | [] -> None
  | (first : Outcome.run) :: others ->
      let shorter (a : Outcome.run) (b : Outcome.run) = if b.at < a.at then b else a in
      Some (List.fold_left shorter first others)

let run context file (check : Checks.t) { Checks.world; first; last; chance } : Outcome.t =
  let outcome ?(measures = []) result evidence =
    {
      Outcome.file;
      label = check.label;
      lasts = check.lasts;
      measures;
      chance;
      note = "";
      result;
      evidence;
    }
  in
  match prepared context file check world with
  | Error reason -> outcome (Error reason) None
  | Ok p -> (
      let progress = Progress.start check.label ~total:(last - first + 1) in
      let result =
        match chance with
        | None -> runs p progress first last
        | Some _ ->
            let decided known = Results.decided (outcome (Ok known) None) in
            until_decided p progress ~decided ~first ~last []
      in
      Progress.finish progress;
      let t = outcome ~measures:p.measures result None in
      match shortest (Results.failures t) with
      | Some ({ seed = Some seed; _ } as run) when Results.has_failed t ->
          { t with evidence = Some (evidence p run seed) }
      | _ -> t)
