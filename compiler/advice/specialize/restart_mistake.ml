open Basis
open Specialize

(* {1 Tasks that take no time} *)

let most_shown = 10

let in_one_instant ~at (hops : Restart_fact.hop list) own =
  let others = List.filteri (fun i _ -> i < most_shown) (List.sort_uniq Span.compare own) in
  (* the label for this place, with the name of the task that ends before it, if it is known *)
  let this_starts place =
    let newest_first = List.rev hops in
    let is_here (hop : Restart_fact.hop) = Span.compare hop.place place = 0 in
    match (List.find_opt is_here newest_first, newest_first) with
    | Some { ended; _ }, _ -> Printf.sprintf "this starts in the instant in which `%s` ends" ended
    | None, { ended; by; _ } :: _ ->
        Printf.sprintf "`%s` may end in its first instant, and `%s` follows it" ended by
    | None, [] -> "this starts in the instant in which the previous task ends"
  in
  let label d place =
    if Span.compare place at = 0 then d else Diagnostic.label ~at:place "%s" (this_starts place) d
  in
  let names = List.concat_map (fun (hop : Restart_fact.hop) -> [ hop.ended; hop.by ]) hops in
  Diagnostic.error ~code:"E0402" ~at "%s may repeat endlessly within one instant"
    (Enumeration.circle names)
  |> Diagnostic.here "%s" (this_starts at)
  |> (fun d -> List.fold_left label d others)
  |> Diagnostic.note
       "a task such as `return` or `snapT` takes no time, and no task in this loop waits for the \
        next instant"
  |> Diagnostic.hint
       "make the loop take time with a task: `untilT (proc x -> (…, condition))` takes at least \
        one instant, and `sleepT 10[ms] …` takes 10 ms; replace `…` with the robot's output"

(* {1 Growth} *)

let before_the_end ~at ~waiting task =
  let advice =
    match task with
    | Some name -> Printf.sprintf "make `%s` the last statement" name
    | None -> "make the call the last statement"
  in
  Diagnostic.(
    error ~code:"E0420" ~at "a task restarts itself, but not as its last statement"
    |> here "it restarts here"
    |> label ~at:waiting "this waits for the restarted task to end"
    |> note "each restart would leave one more statement waiting, but memory is fixed"
    |> hint
         "%s, or move the waiting statements into the branch that ends the task; to repeat a task, \
          write `repeatT 4 t` or `forever t`"
         advice)

let growing ~at ~name ~is_task ~added ~is_choice way =
  let on_the_way (diagnostic, shown) (name, place) =
    if List.mem place shown then (diagnostic, shown)
    else
      let text = Printf.sprintf "`%s` starts here, between two restarts" name in
      (Diagnostic.label ~at:place "%s" text diagnostic, place :: shown)
  in
  let what = if is_task then "tasks" else "signal functions" in
  Diagnostic.(
    error ~code:"E0416" ~at "`%s` grows each time it restarts itself" name
    |> here "it restarts here, with one more `%s`" added
    |> (fun diagnostic -> fst (List.fold_left on_the_way (diagnostic, [ at ]) way))
    |> note "frobc must know all %s that can run, so their number must be finite" what
    |> hint "restart it with the same %s each time; only numbers may change" what
    |>
    if is_choice then
      hint "pass the condition of the `if` as an argument, and choose inside `%s`" name
    else Fun.id)

(* {1 Nested restarts} *)

let inside_itself ~at:span ~name ~is_task ~goes_on (calls : Calls.t) =
  let _, at = List.hd calls in
  let wrappers =
    List.fold_left
      (fun names (wrapper, _) -> if List.mem wrapper names then names else wrapper :: names)
      [] calls
  in
  let quoted = List.rev_map (Printf.sprintf "`%s`") wrappers in
  let own (place : Span.t) = String.equal place.file at.file in
  (* does it restart itself directly, rather than inside calls to other functions? *)
  let by_itself = List.for_all (String.equal name) wrappers && own span && span <> at in
  let place = if by_itself then span else at in
  let label d (text, where) =
    if own where && where <> place then Diagnostic.label ~at:where "%s" text d else d
  in
  let runs_here (wrapper, where) = (Printf.sprintf "`%s` runs here" wrapper, where) in
  let error =
    Diagnostic.error ~code:"E0415" ~at:place "`%s` restarts itself inside itself" name
    |> Diagnostic.here "%s"
         (if by_itself then
            Printf.sprintf "`%s` keeps running while the signal function here runs" name
          else "here, inside " ^ String.concat ", inside " quoted)
  in
  let labels =
    if by_itself then [ (Printf.sprintf "`%s` restarts here" name, at) ]
    else List.map runs_here (List.tl calls)
  in
  List.fold_left label error labels
  |> Diagnostic.note "%s"
       (if is_task then
          "a task may only restart itself as the last statement of its `do`, and nothing around \
           that `do` may keep running; otherwise each restart would need more memory"
        else
          "a signal function may only restart itself as the whole result of a continuation; \
           otherwise each restart would need more memory")
  |> Diagnostic.hint "%s"
       (if is_task then
          "to repeat a task, write `repeatT 4 t`, `whileT condition t` or `forever t`, followed by \
           the statements to run after all repetitions"
        else if by_itself && goes_on then
          "use `switch`, which ends when its continuation starts; `rSwitch` never ends"
        else if by_itself then
          Printf.sprintf
            "start this signal function in the continuation of a `switch` that ends `%s`, or \
             choose between the two with a signal"
            name
        else
          Printf.sprintf "apply %s once, where the first mode starts, not in each mode"
            (String.concat ", " quoted))

let diagnostic (fact : Restart_fact.t) =
  match fact with
  | In_one_instant { at; hops; own } -> in_one_instant ~at hops own
  | Before_the_end { at; waiting; task } -> before_the_end ~at ~waiting task
  | Growing { at; name; is_task; added; is_choice; way } ->
      growing ~at ~name ~is_task ~added ~is_choice way
  | Inside_itself { at; name; is_task; goes_on; calls } ->
      inside_itself ~at ~name ~is_task ~goes_on calls
