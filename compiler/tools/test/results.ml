open Outcome

let is_failure r = match r.fate with Violated | Undecided -> true | Held | Unasked | Void -> false
let runs t = Result.value t.result ~default:[]
let failures t = List.filter is_failure (runs t)
let counted t = List.filter (fun r -> r.fate <> Void) (runs t)

(* Decides, from the runs so far, whether the property holds in the required proportion of runs.
   Also returns the number of runs that the decision took. *)
let decision t chance = Chance.decide chance (List.map (fun r -> not (is_failure r)) (counted t))

let decided t =
  let after chance =
    match decision t chance with
    | Chance.Open, _ -> None
    | (Holds | Fails), count ->
        let rec number k counted = function
          | _ when counted = 0 -> k
          | run :: rest -> number (k + 1) (if run.fate = Void then counted else counted - 1) rest
          | [] -> k
        in
        Some (number 0 count (runs t))
  in
  Option.bind t.chance after

let has_failed t =
  Result.is_error t.result
  ||
  match t.chance with
  | None -> failures t <> []
  | Some chance -> fst (decision t chance) <> Chance.Holds

let count fate t = List.length (List.filter (fun r -> r.fate = fate) (runs t))
let plural n word = Printf.sprintf "%d %s%s" n word (if n = 1 then "" else "s")

let why r =
  match r.fate with
  | Violated when r.by = "judge" -> Printf.sprintf "failed at %.3f s" r.at
  | Violated -> Printf.sprintf "`%s` violated at %.3f s" r.by r.at
  | Undecided -> Printf.sprintf "undecided at the end, after %g s" r.at
  | Held | Unasked | Void -> ""

let seed r = match r.seed with Some seed -> Printf.sprintf "seed %d: " seed | None -> ""

let of_chance t (chance : Chance.t) =
  let total = List.length (counted t) in
  let held = total - List.length (failures t) in
  let least, most = Chance.bounds ~confidence:chance.confidence ~held (max 1 total) in
  let said =
    match fst (decision t chance) with
    | Holds -> "holds in at least"
    | Fails -> "does not hold in"
    | Open -> "undecided whether it holds in at least"
  in
  Printf.sprintf
    "%s %g of runs, with confidence %g: held in %d of %s, so the true fraction is between %.4f and \
     %.4f"
    said chance.share chance.confidence held (plural total "run") least most

(* The failed runs; the first one is the run that the evidence describes. *)
let told t =
  match (t.evidence, failures t) with
  | Some e, _ :: others -> e.run :: others
  | _, failures -> failures

let verdict t =
  match (t.result, told t) with
  | Error reason, _ -> reason
  | Ok _, failures when t.chance <> None -> (
      let said = of_chance t (Option.get t.chance) in
      match failures with
      | first :: _ when has_failed t -> Printf.sprintf "%s; %s%s" said (seed first) (why first)
      | _ -> said)
  | Ok [ { seed = None; _ } ], first :: _ -> why first
  | Ok runs, first :: _ ->
      Printf.sprintf "%d of %s; %s%s"
        (List.length (failures t))
        (plural (List.length runs) "seed")
        (seed first) (why first)
  | Ok runs, [] ->
      let total = List.length runs in
      let seeds =
        match runs with [ { seed = None; _ } ] -> "" | _ -> plural total "seed" ^ ", "
      in
      let some n what = if n = 0 then "" else Printf.sprintf "; %s %s" (plural n "run") what in
      Printf.sprintf "%s%g s%s%s%s" seeds t.lasts
        (if t.note = "" then "" else "; " ^ t.note)
        (some (count Void t) "void because an assumption failed")
        (if count Unasked t = total then "; never checked" else "")

(* Describes a collision in the same words as the simulator's summary of a run. *)
let collision_line c =
  Printf.sprintf "collision at %.3f s: %s, x %.3f m, y %.3f m, clearance %.3f m" c.time c.with_ c.x
    c.y c.clearance

let truth_lines r =
  match r.truth with
  | [ x; y; heading; clearance; _touches; driven; lost ] ->
      [
        Printf.sprintf
          "x %.3f m, y %.3f m, heading %.3f rad, clearance %.3f m, %.3f m driven, odometry off by \
           %.3f m"
          x y heading clearance driven lost;
        Printf.sprintf "collisions: %d" r.collisions;
      ]
      @ List.map collision_line (Option.to_list r.first)
  | _ -> []

let of_measure (m : Measures.t) r =
  Option.value (List.assoc_opt m.probe r.measured) ~default:Float.nan

let spreads t =
  let counted = counted t in
  let spread (m : Measures.t) =
    Spread.text ~name:m.name ~unit_:m.unit_
      (List.map (fun r -> (Option.value r.seed ~default:0, of_measure m r)) counted)
  in
  if counted = [] then [] else List.map spread t.measures

let look_lines (run : run) { around; picture; view } =
  truth_lines run @ around
  @ (if picture = "" then [] else [ "picture: " ^ picture ])
  @ if view = "" then [] else [ view ]

let simpler_lines { needs; world; again; seen } =
  let disturbances =
    match needs with
    | [] -> "without any of the world's disturbances"
    | names ->
        Printf.sprintf "with none of the world's disturbances except %s"
          (Basis.Enumeration.all names)
  in
  Printf.sprintf "a simpler run, %s, also fails: %s%s" disturbances (seed again) (why again)
  :: List.map (( ^ ) "  ") (("world: " ^ world) :: look_lines again seen)

(* The details of the reported run, then separately those of a simpler run. *)
let evidence_lines e =
  look_lines e.run e.look
  @ Option.fold ~none:[] ~some:simpler_lines e.simpler
  @ if e.note = "" then [] else [ e.note ]

let print t =
  Printf.printf "%s  %s: %s\n"
    (if has_failed t then "FAIL" else "ok  ")
    (Basis.Printable.name t.label)
    (Basis.Printable.name (verdict t));
  let detail line = Printf.printf "      %s\n" (Basis.Printable.name line) in
  List.iter detail (spreads t);
  Option.iter (fun e -> List.iter detail (evidence_lines e)) t.evidence;
  flush stdout

let print_skipped { name; what; command; _ } =
  let shown = Basis.Printable.name in
  Printf.printf "skip  %s: needs %s\n      %s\n" (shown name) (shown what) (shown command);
  flush stdout

let print_total all ~skipped =
  let failed = List.length (List.filter has_failed all) in
  Printf.printf "%s: %s%s\n"
    (plural (List.length all) "test")
    (if failed = 0 then "all hold" else Printf.sprintf "%d failed" failed)
    (if skipped = 0 then "" else Printf.sprintf "; %d skipped" skipped)

let fate_name = function
  | Held -> "held"
  | Violated -> "violated"
  | Undecided -> "undecided"
  | Unasked -> "unasked"
  | Void -> "void"

(* {1 JSON} *)

let collision_json c =
  let open Basis.Json in
  Object
    [
      ("time", Float c.time);
      ("with", String c.with_);
      ("x", Float c.x);
      ("y", Float c.y);
      ("clearance", Float c.clearance);
    ]

let truth_json r =
  let open Basis.Json in
  match r.truth with
  | [ x; y; heading; clearance; touches; driven; lost ] ->
      [
        ("x", Float x);
        ("y", Float y);
        ("heading", Float heading);
        ("clearance", Float clearance);
        ("touches", Bool (touches <> 0.));
        ("driven", Float driven);
        ("odometry_error", Float lost);
        ("collisions", Int r.collisions);
      ]
      @ Option.fold ~none:[] ~some:(fun c -> [ ("first_collision", collision_json c) ]) r.first
  | _ -> []

let measured_json t r =
  let open Basis.Json in
  let value (m : Measures.t) =
    let x = of_measure m r in
    if Float.is_finite x then Some (m.name, Float x) else None
  in
  match List.filter_map value t.measures with [] -> [] | values -> [ ("measured", Object values) ]

let run_json t r =
  let open Basis.Json in
  let seed = match r.seed with Some seed -> [ ("seed", Int seed) ] | None -> [] in
  Object
    (seed
    @ [ ("fate", String (fate_name r.fate)); ("at", Float r.at); ("by", String r.by) ]
    @ truth_json r @ measured_json t r)

let evidence_json t =
  let open Basis.Json in
  let look { picture; view; around = _ } = [ ("picture", String picture); ("view", String view) ] in
  let simpler { needs; world; again; seen } =
    Object
      ([
         ("needs", List (List.map (fun name -> String name) needs));
         ("world", String world);
         ("run", run_json t again);
       ]
      @ look seen)
  in
  match t.evidence with
  | Some e ->
      look e.look
      @ Option.fold ~none:[] ~some:(fun s -> [ ("simpler", simpler s) ]) e.simpler
      @ if e.note = "" then [] else [ ("note", String e.note) ]
  | None -> []

let chance_json t (chance : Chance.t) =
  let open Basis.Json in
  let total = List.length (counted t) in
  let held = total - List.length (failures t) in
  let least, most = Chance.bounds ~confidence:chance.confidence ~held (max 1 total) in
  let decision =
    match fst (decision t chance) with Holds -> "holds" | Fails -> "fails" | Open -> "open"
  in
  Object
    [
      ("share", Float chance.share);
      ("confidence", Float chance.confidence);
      ("decision", String decision);
      ("least", Float least);
      ("most", Float most);
    ]

let outcome_json t =
  let open Basis.Json in
  let chance = Option.fold t.chance ~none:[] ~some:(fun c -> [ ("chance", chance_json t c) ]) in
  let result =
    match t.result with
    | Ok runs -> ("runs", List (List.map (run_json t) runs))
    | Error reason -> ("error", String reason)
  in
  Object
    ([
       ("file", String t.file);
       ("label", String t.label);
       ("ok", Bool (not (has_failed t)));
       ("lasts", Float t.lasts);
     ]
    @ chance @ (result :: evidence_json t))

let json t = Basis.Json.to_string (outcome_json t)

let skipped_json { path; name; what; command } =
  let open Basis.Json in
  to_string
    (Object
       [
         ("file", String path);
         ("label", String name);
         ("skipped", String ("needs " ^ what));
         ("command", String command);
       ])

let junit all skipped =
  let name file label =
    Printf.sprintf "classname=\"%s\" name=\"%s\"" (Xml.escaped file) (Xml.escaped label)
  in
  let case t =
    let name = name t.file t.label in
    if not (has_failed t) then Printf.sprintf "  <testcase %s/>\n" name
    else
      let more = Option.fold ~none:[] ~some:evidence_lines t.evidence in
      Printf.sprintf "  <testcase %s>\n    <failure message=\"%s\">%s</failure>\n  </testcase>\n"
        name
        (Xml.escaped (verdict t))
        (Xml.escaped (String.concat "\n" more))
  in
  let left_out s =
    Printf.sprintf
      "  <testcase %s>\n    <skipped message=\"needs %s\">%s</skipped>\n  </testcase>\n"
      (name s.path s.name) (Xml.escaped s.what) (Xml.escaped s.command)
  in
  Printf.sprintf
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
     <testsuite name=\"frobc test\" tests=\"%d\" failures=\"%d\" skipped=\"%d\">\n\
     %s%s</testsuite>\n"
    (List.length all + List.length skipped)
    (List.length (List.filter has_failed all))
    (List.length skipped)
    (String.concat "" (List.map case all))
    (String.concat "" (List.map left_out skipped))
