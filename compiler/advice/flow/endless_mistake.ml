open Basis
open Flow

let map = Long_list.map

(* The hint depends on the source of the event. The source of a library time-out is the prelude's
   [after] or [elapsed]. The user cannot change the other events inside the library, so for those
   the hint is about the loop. *)
let hint ~entry ~(by : Ir.follower) sources =
  match (List.map fst sources, by) with
  | "after" :: _, _ -> "make the wait at least 1 ns long, for example with `after (max 1[ms] q)`"
  | "elapsed" :: _, _ -> "make the wait at least 1 ns long, for example with `max 1[ms] q`"
  | _ :: _, _ when not (List.exists (fun (_, at) -> Own_code.is_own ~entry at) sources) ->
      "make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where \
       `restingOutput` is the output of a robot at rest"
  | _, Statement _ ->
      "use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at \
       least one instant; `edge` would wait forever if the condition were true from the start"
  | _, Continuation _ ->
      "apply `notYet` to the event to ignore it at the first instant; `edge` would wait forever if \
       the condition were true from the start"

(* Lists the modes of the cycle. Each mode is followed by the definition that determines the next
   mode, unless that definition is one of these two modes. *)
let circle hops =
  let names (from, target, (by : Ir.follower)) =
    match by with
    | (Continuation name | Statement name) when name <> from && name <> target -> [ from; name ]
    | Continuation _ | Statement _ -> [ from ]
  in
  Enumeration.circle (List.concat_map names hops)

(* A note that states in which case no time passes between the modes. *)
let note modes =
  let at_which what = Printf.sprintf "no time passes between these steps when %s" what in
  match List.sort_uniq compare modes with
  | [ (mode, Some event) ] when mode <> event ->
      at_which (Printf.sprintf "`%s` occurs as soon as `%s` starts" event mode)
  | [ (mode, _) ] -> at_which (Printf.sprintf "`%s` ends as soon as it starts" mode)
  | _ -> at_which "each ends as soon as it starts"

(* {1 The modes of the cycle} *)

type cycle = { entry : Span.t; program : Ir.program }

let mode_node cycle mode = cycle.program.nodes.(mode)
let is_own cycle = Own_code.is_own ~entry:cycle.entry

(* Whether a place is in the prelude. Instead of such a place, messages show where the program uses
   the prelude. *)
let in_prelude cycle (at : Span.t) =
  String.equal (Filename.basename at.file) "Prelude.frob" && not (is_own cycle at)

let is_task cycle origin (node : Ir.node) =
  String.equal node.origin origin && Option.is_some node.machine && is_own cycle node.span

(* The name of a mode in messages. If a combinator runs a definition of the program, messages name
   that definition, because it is the part that may end. *)
let mode_name cycle (step : Fact.step) =
  let here = mode_node cycle step.mode in
  let is_elsewhere origin (node : Ir.node) =
    let is_within =
      String.equal here.span.file node.span.file
      && Span.compare (Span.merge here.span node.span) here.span = 0
    in
    is_task cycle origin node && not is_within
  in
  let is_combinator's =
    Option.fold step.source ~none:false ~some:(fun (_, at) -> in_prelude cycle at)
  in
  match (step.by.by, step.source) with
  | Statement _, Some (origin, _) when Array.exists (is_elsewhere origin) cycle.program.nodes ->
      origin
  (* A task that ends inside a combinator gets the name of the definition that determines the next
     mode. *)
  | Statement definition, _ when is_combinator's && is_own cycle step.by.span -> definition
  | (Statement _ | Continuation _), _ -> here.origin

(* Tasks written inside a mode end when the mode ends, so the message names the mode rather than
   such a task. *)
let within_mode cycle name (step : Fact.step) =
  let of_task (origin, at) =
    ( (if Array.exists (is_task cycle origin) cycle.program.nodes then name step.mode else origin),
      at )
  in
  match step.by.by with
  | Statement _ -> { step with source = Option.map of_task step.source }
  | Continuation _ -> step

let by_prelude cycle (step : Fact.step) =
  is_own cycle (mode_node cycle step.mode).span
  && Option.fold step.source ~none:false ~some:(fun (_, at) -> in_prelude cycle at)

type remark =
  | May_end of string
  | May_occur of { event : string; mode : string }
  | May_restart of string
  | May_start of { from : string; target : string }
  | Again

let label d (at, remark) =
  let label format = Diagnostic.label ~at format in
  match remark with
  | May_end mode -> label "`%s` may end at its first instant" mode d
  | May_occur { event; mode } -> label "`%s` may occur at the first instant of `%s`" event mode d
  | May_restart mode -> label "`%s` may start itself again at its own first instant" mode d
  | May_start { from; target } -> label "`%s` may start `%s` at its own first instant" from target d
  | Again -> label "and again here" d

(* If several modes have the same name, adds the remark only once. *)
let add remark remarks = if List.mem remark remarks then remarks else remarks @ [ remark ]

let add_step cycle name remarks (step : Fact.step) =
  let from = name step.mode and target = name step.target in
  let remarks =
    match step.source with
    | Some _ when by_prelude cycle step -> remarks
    | Some (origin, at) when origin = from -> add (at, May_end origin) remarks
    | Some (origin, at) -> add (at, May_occur { event = origin; mode = from }) remarks
    | None -> remarks
  in
  let at = step.by.span in
  let remark = if from = target then May_restart from else May_start { from; target } in
  let is_elsewhere (there, other) = other = remark && there <> at in
  add (at, if List.exists is_elsewhere remarks then Again else remark) remarks

let diagnostic ~at ~entry program steps ~limit =
  let cycle = { entry; program } in
  let names = map (fun (step : Fact.step) -> (step.mode, mode_name cycle step)) steps in
  let name mode = List.assoc mode names in
  let steps = map (within_mode cycle name) steps in
  let round = circle (map (fun (s : Fact.step) -> (name s.mode, name s.target, s.by.by)) steps) in
  let d = Diagnostic.error ~code:"E0402" ~at "%s may repeat endlessly within one instant" round in
  let starts_there (step : Fact.step) = Span.compare (mode_node cycle step.mode).span at = 0 in
  let d =
    if List.exists (fun step -> by_prelude cycle step && starts_there step) steps then
      Diagnostic.here "this may end as soon as it starts" d
    else d
  in
  let sources = List.filter_map (fun (step : Fact.step) -> step.source) steps in
  let by : Ir.follower = match steps with step :: _ -> step.by.by | [] -> Continuation "" in
  let event step = if by_prelude cycle step then None else Option.map fst step.source in
  let far limit =
    Diagnostic.note
      "frobc stopped after %d steps, the maximum for one instant, without finding an end" limit
  in
  List.fold_left label d (List.fold_left (add_step cycle name) [] steps)
  |> Diagnostic.note "%s"
       (note (map (fun (step : Fact.step) -> (name step.mode, event step)) steps))
  |> Option.fold ~none:Fun.id ~some:far limit
  |> Diagnostic.hint "%s" (hint ~entry ~by sources)
