open Basis
open Checking

let ( let* ) = Result.bind

(* Beside the program, or of those that come with frobc. *)
let world_of context file name =
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

type prepared = {
  context : Checking.t;
  file : string;
  check : Checks.t;
  world : string; (* the path *)
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
  let* program = compiled context general ~entry:"main" file in
  Ok { context; file; check; world; program; judge; measures }

let command p ?(world = p.world) (first, last) more =
  let { Checking.resources; options; _ } = p.context in
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

(* {1 All seeds} *)

let runs p progress first last =
  let jobs = p.context.jobs in
  let parts = Array.of_list (chunks ~jobs first last) in
  let ended part =
    let first, last = parts.(part) in
    Progress.add progress (last - first + 1)
  in
  let commands = List.map (fun part -> command p part []) (Array.to_list parts) in
  let results = Workers.run ~ended ~jobs commands in
  match List.find_opt (fun (r : Workers.result) -> r.status <> 0) results with
  | Some result -> Error (complaint result)
  | None -> Ok (List.concat_map (fun (r : Workers.result) -> Found.of_trial r.output) results)

(* Until it is decided. Runs are made many at a time, and those behind the one that decided are
   dropped: so the outcome does not depend on how many. *)
let rec until_decided p progress ~decided ~first ~last known =
  match decided known with
  | Some count -> Ok (List.filteri (fun k _ -> k < count) known)
  | None when first > last -> Ok known
  | None ->
      let upto = min last (first + max 32 (List.length known) - 1) in
      let* more = runs p progress first upto in
      until_decided p progress ~decided ~first:(upto + 1) ~last (known @ more)

(* {1 One that fails} *)

let output content path = { Output.path; content; asked = "--keep" }

let fails_so p (run : Outcome.run) ~world seed =
  match Workers.run ~jobs:1 [ command p ~world (seed, seed) [] ] with
  | [ { status = 0; output; _ } ] -> (
      match Found.of_trial output with
      | [ again ] -> again.fate = run.fate && String.equal again.by run.by
      | _ -> false)
  | _ -> false

(* The world with those disturbances alone that the run needs to fail so, and what to say of it.
   A world that names files is left as it is: it would not find them from elsewhere. *)
let shrunk p run seed =
  let text = read p.world in
  let all = Disturbances.of_world text in
  let trial = Filename.concat (Temporary.folder ()) "world.toml" in
  let still_fails left_out =
    let channel = open_out_bin trial in
    output_string channel (Disturbances.without left_out text);
    close_out channel;
    fails_so p run ~world:trial seed
  in
  if all = [] || Disturbances.names_files text then (p.world, "")
  else
    let needed = Disturbances.needed ~still_fails all in
    let left_out = List.filter (fun t -> not (List.mem t needed)) all in
    if left_out = [] then (p.world, "")
    else
      let path = kept p.context p.check (Printf.sprintf "-%d.toml" seed) in
      let head =
        Printf.sprintf "# written by frobc: %s, without what a run does not need to fail\n"
          (Filename.basename p.world)
      in
      let written =
        let* () = Output.folder p.context.options.keep in
        let* () = Output.check ~reads:[ p.file; p.world ] [ output World path ] in
        Output.write [ (path, head ^ Disturbances.without left_out text) ]
      in
      match (written, needed) with
      | Error reason, _ -> (p.world, reason)
      | Ok (), [] -> (path, "fails so without any of the world's disturbances: " ^ path)
      | Ok (), _ ->
          let names = Enumeration.all (List.map Disturbances.name needed) in
          (path, Printf.sprintf "of the world's disturbances it needs %s: %s" names path)

let evidence p (run : Outcome.run) seed : Outcome.evidence =
  let world, shrunk = shrunk p run seed in
  let ending extension = Printf.sprintf "-%d%s" seed extension in
  let record = kept p.context p.check (ending ".csv") in
  let picture = kept p.context p.check (ending ".png") in
  let again =
    let* () = Output.folder p.context.options.keep in
    let* () =
      Output.check ~reads:[ p.file; p.world ] [ output Table record; output Picture picture ]
    in
    let more = [ "--record"; record; "--picture"; picture ] in
    match Workers.run ~jobs:1 [ command p ~world (seed, seed) more ] with
    | [ { status = 0; output; _ } ] -> (
        match Found.of_trial output with
        | [ again ] -> Ok again
        | _ -> Error "the run could not be recorded")
    | _ -> Error "the run could not be recorded"
  in
  match again with
  | Ok again ->
      let view =
        Printf.sprintf "frobc view %s %s%s --world %s --seed %d --at %s" (quoted record)
          (quoted p.file) (robot_option p.context.general) (quoted world) seed
          (Time_span.print again.at)
      in
      let around = Found.around (read record) in
      { run; truth = again.truth; around; shrunk; picture; view }
  | Error reason -> { run; truth = []; around = [ reason ]; shrunk; picture = ""; view = "" }

(* {1 All of it} *)

(* The shortest of the runs that failed. *)
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
            let decided known = Outcome.decided (outcome (Ok known) None) in
            until_decided p progress ~decided ~first ~last []
      in
      Progress.finish progress;
      let t = outcome ~measures:p.measures result None in
      match shortest (Outcome.failures t) with
      | Some ({ seed = Some seed; _ } as run) when Outcome.has_failed t ->
          { t with evidence = Some (evidence p run seed) }
      | _ -> t)
