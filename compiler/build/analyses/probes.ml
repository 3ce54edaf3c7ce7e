open Basis

let unknown = "E0506"
let claims = Probe.Selection.claims

let refuse sink diagnostic =
  Diagnostic.emit sink diagnostic;
  None

(* The place of the entry's name, which is at the start of its definition. *)
let name_of (entry : Typing.Ir.definition) =
  let { Span.file; start; _ } = entry.span in
  Span.make ~file ~start ~stop:(Span.forward (String.length entry.name.name) start)

let all sink entry core flow =
  match Probe.Catalogue.of_program (Probe.Equations.of_program core) flow with
  | Some all -> Some all
  | None ->
      Diagnostic.error ~code:unknown ~at:(name_of entry)
        "more than %d signal functions run in this program" Probe.Catalogue.most
      |> Diagnostic.note "frobc cannot name the signals of a program with more signal functions"
      |> refuse sink

let named sink entry core flow ~asserts names =
  Option.bind (all sink entry core flow) (fun all ->
      match Probe.Selection.find all names with
      | Ok shown ->
          let with_whether_shown p =
            let is_shown = List.memq p shown in
            if is_shown || (asserts && Probe.Selection.is_claim p) then Some (p, is_shown) else None
          in
          Some (List.filter_map with_whether_shown all)
      | Error (name, nearest) ->
          let closest name = Diagnostic.hint "did you mean `%s`?" name in
          Diagnostic.error ~code:unknown ~at:(name_of entry) "this program has no inner signal `%s`"
            name
          |> Option.fold ~none:Fun.id ~some:closest nearest
          |> Diagnostic.hint "`--probe list` lists all inner signals"
          |> refuse sink)

let causal flow probes =
  let is_causal probes = Flow.Causality.is_causal (Probe.Observed.program flow probes) in
  (* Uses bisection, because usually all or nearly all probes are causal. *)
  let rec add shown probes =
    match probes with
    | [] -> shown
    | _ when is_causal (shown @ probes) -> shown @ probes
    | [ _ ] -> shown
    | _ ->
        let half = List.length probes / 2 in
        let first, rest = Long_list.split_at half probes in
        add (add shown first) rest
  in
  let shown = add [] probes in
  if List.compare_lengths shown probes = 0 then (probes, [])
  else List.partition (fun p -> List.memq p shown) probes

let warn_unwatched sink (p : Probe.Catalogue.probe) =
  Diagnostic.warning ~code:"W0311" ~at:p.span "this assertion is not checked"
  |> Diagnostic.note
       "it is inside a switch whose output is fed back to it, and showing an inner signal would \
        make all outputs of the switch depend on that signal"
  |> Diagnostic.hint "move the assertion to where the output of the switch is used"
  |> Diagnostic.emit sink

let warn_of_claims sink entry core flow =
  let claims = Option.value (named sink entry core flow ~asserts:true []) ~default:[] in
  List.iter (warn_unwatched sink) (snd (causal flow (List.map fst claims)))

let refuse_hidden sink entry ~names (hidden : Probe.Catalogue.probe list) =
  let claims, hidden = List.partition Probe.Selection.is_claim hidden in
  let hidden = List.filter (fun p -> not (Probe.Selection.is_margin p)) hidden in
  List.iter (warn_unwatched sink) claims;
  match hidden with
  | { name; _ } :: _ when not (List.mem "all" names) ->
      Diagnostic.error ~code:unknown ~at:(name_of entry) "`%s` cannot be shown" name
      |> Diagnostic.note
           "it is inside a switch whose output is fed back to it, and showing an inner signal \
            would make all outputs of the switch depend on that signal"
      |> refuse sink
  | _ -> Some ()

let list typed (flow : Flow.Ir.program) probes =
  let types = Probe.Instance_types.of_program typed flow in
  let shown = List.filter (fun (p : Probe.Catalogue.probe) -> not p.handed_down) probes in
  let type_ (p : Probe.Catalogue.probe) =
    match (Probe.Instance_types.type_of types p, p.own) with
    | Some ty, _ -> Typing.Show.ty ty
    | None, Signal s -> Flow.Print.ty flow.sums s.ty
    | None, Running_mode -> String.concat " | " (Probe.Catalogue.modes_of flow p)
  in
  let rows = List.map (fun (p : Probe.Catalogue.probe) -> (p, type_ p)) shown in
  let width select =
    List.fold_left (fun most row -> max most (String.length (select row))) 0 rows
  in
  let name ((p : Probe.Catalogue.probe), _) = p.name in
  let longest_name = min 50 (width name) and longest_type = min 30 (width snd) in
  let line ((p : Probe.Catalogue.probe), type_) =
    Printf.sprintf "%-*s :: %-*s  %s:%d\n" longest_name p.name longest_type type_
      (Filename.basename p.span.file) (Span.line p.span.start)
  in
  String.concat "" (List.map line rows)
