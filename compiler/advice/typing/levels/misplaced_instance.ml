open Basis
open Typing
open Typing.Ir

let rec head_name (h : expr) =
  match h.desc with
  | Local (x, _) -> Some x.name
  | Global (g, _) | Primitive (g, _) | Method { method_ = g; _ } -> Some g.name
  | Apply (f, _) -> head_name f
  | _ -> None

let name h =
  match head_name h with Some name -> Printf.sprintf "`%s`" name | None -> "a signal function"

(* {1 Hints} *)

let quote = Settings.quote
let signal h = Option.fold (head_name h) ~none:"itsValue" ~some:(fun name -> name ^ "Now")

let equation sources h (e : expr) =
  Printf.sprintf "`%s = %s`" (signal h) (Option.value (quote sources e) ~default:"…")

let own_equation sources h e =
  Diagnostic.hint "to run it at every instant, add the equation %s, and write `%s` here"
    (equation sources h e) (signal h)

(* The hint that explains how to pause an integral while the branch is not chosen. *)
let paused sources condition h input =
  match (head_name h, condition) with
  | Some "integral", Some ({ test; chosen_if } : Level_fact.condition) -> (
      match (quote sources test, quote sources input) with
      | Some test, Some input ->
          let input = if String.contains input '$' then Source.grouped input else input in
          let rate =
            if chosen_if then Printf.sprintf "if %s then %s else 0" test input
            else Printf.sprintf "if %s then 0 else %s" test input
          in
          Diagnostic.hint
            "to pause it while this branch is not chosen, write `integral (%s)` in place of the \
             whole `if`"
            rate
      | _ -> Fun.id)
  | _ -> Fun.id

(* The hint that explains how to restart the signal function whenever the branch is chosen. *)
let anew sources condition h input =
  let resets ({ test; chosen_if } : Level_fact.condition) =
    match (quote sources h, quote sources input, quote sources test) with
    | Some h', Some input, Some test ->
        let becomes =
          if chosen_if then Source.grouped test else Printf.sprintf "(not %s)" (Source.grouped test)
        in
        let input = if String.contains input '$' then Source.grouped input else input in
        Some
          (Printf.sprintf
             "to restart it whenever this branch is chosen, write `%s = resetOn %s (%s, edge %s)`"
             (signal h) (Source.grouped h') input becomes)
    | _ -> None
  in
  Diagnostic.hint "%s"
    (Option.value (Option.bind condition resets)
       ~default:
         "to restart it whenever this alternative is chosen, use `switch` to change between signal \
          functions")

(* The signature of this definition with its last `a -> b` replaced by `SF a b`, if the signature
   has one arrow for each parameter. *)
let as_a_signal_function sources (span : Span.t) name parameters =
  let prefix = name ^ " :: " in
  let is_plain text = not (String.exists (fun c -> c = '(' || c = ')') text) in
  let split_constraint text =
    match String.index_opt text '=' with
    | Some i when i + 3 < String.length text && text.[i + 1] = '>' ->
        (String.sub text 0 (i + 3), String.sub text (i + 3) (String.length text - i - 3))
    | _ -> ("", text)
  in
  let of_line line =
    if not (String.starts_with ~prefix line) then None
    else
      let n = String.length prefix in
      let given, type_ = split_constraint (String.sub line n (String.length line - n)) in
      let parts = List.map String.trim (String.split_on_char '>' type_) in
      let without_arrow part =
        let n = String.length part in
        if n > 1 && part.[n - 1] = '-' then String.trim (String.sub part 0 (n - 1)) else part
      in
      match List.rev_map without_arrow parts with
      | b :: a :: before when List.length before = parameters - 1 && is_plain type_ ->
          let last = Printf.sprintf "SF %s %s" (Source.grouped a) (Source.grouped b) in
          Some (prefix ^ given ^ String.concat " -> " (List.rev (last :: before)))
      | _ -> None
  in
  match Source.text sources span.file with
  | Some text -> List.find_map of_line (String.split_on_char '\n' text)
  | None -> None

(* Rewrites `f d i = sf i` as `f d = proc i -> sf i`, and returns it with its new signature. *)
let as_a_proc sources (value : expr) =
  match value.desc with
  | Lambda ((_ :: _ as patterns), _) -> (
      let span = (List.nth patterns (List.length patterns - 1)).span in
      match (Source.quote sources span, Source.line sources span.file (Span.line span.start)) with
      | Some pattern, Some line ->
          let first = Span.column span.start - 1 and stop = Span.column span.stop - 1 in
          let left = String.trim (String.sub line 0 first) in
          let right = String.trim (String.sub line stop (String.length line - stop)) in
          let n = String.length right in
          let is_left = String.for_all (fun c -> Character.is_name c || c = ' ') left in
          if n > 2 && n < 80 && String.starts_with ~prefix:"= " right && line.[0] <> ' ' && is_left
          then
            let name = List.hd (String.split_on_char ' ' left) in
            let body = String.trim (String.sub right 1 (n - 1)) in
            Some
              ( Printf.sprintf "%s = proc %s -> %s" left pattern body,
                as_a_signal_function sources span name (List.length patterns) )
          else None
      | _ -> None)
  | _ -> None

let outside sources value head =
  match as_a_proc sources value with
  | Some (definition, Some signature) ->
      Printf.sprintf "run it in a `proc`: write `%s`, and below it `%s`" signature definition
  | Some (definition, None) ->
      Printf.sprintf "run it in a `proc`: `%s`; the type `a -> b` then becomes `SF a b`" definition
  | None ->
      Printf.sprintf
        "run it in a `proc`, as in `f = proc x -> %s`; the type `a -> b` then becomes `SF a b`"
        (match quote sources head with Some h -> h ^ " x" | None -> "…")

(* {1 Messages} *)

(* The hint for a `test` that does not say how long to run, as in `test "…" = ramp 0 == 0`. *)
let in_a_test sources (definition : Global.t) (value : expr) =
  let value = match value.desc with Apply (_, e) -> e | _ -> value in
  match Resolve.Labels.kind_of_check definition.name with
  | Some (Test, _) ->
      Some
        (Printf.sprintf "in the test, run it for some time: `during 1[s] (proc () -> %s)`"
           (Option.value (quote sources value) ~default:"…"))
  | Some (Trial, _) | None -> None

let diagnostic sources ~definition ~within (position : Level_fact.position)
    (obstacle : Level_fact.obstacle) (e : expr) ~head ~input =
  let run where code = Diagnostic.error ~code ~at:e.span "%s is run %s" (name head) where in
  let bound (x : Local.t) d =
    Diagnostic.here "`%s` has a value only here" x.name d
    |> Diagnostic.label ~at:x.span "`%s` is bound here" x.name
  in
  let of_choice where condition =
    let d = run where "E0342" in
    match obstacle with
    | Own_definition ->
        Diagnostic.error ~code:"E0342" ~at:e.span "%s is run in its own definition" (name head)
        |> Diagnostic.hint
             "an equation holds at every instant, so a signal function need not call itself to \
              continue"
        |> Diagnostic.hint
             "to change what runs after an event, use `switch (proc x -> (output, event)) (\\_ -> \
              …)`; replace `…` with the signal function to run next, which may be this one"
    | Depends_on_start | Lifted ->
        Diagnostic.here "its output depends on when it started" d
        |> own_equation sources head e |> anew sources condition head input
        |> paused sources condition head input
    | Bound_here x ->
        bound x d
        |> Diagnostic.hint
             "a signal function runs at every instant: use an input that always has a value, or \
              run it on events with `onEvent`"
  in
  match position with
  | Every_instant ->
      Diagnostic.bug ~stage:"Advice.Misplaced_instance" "an instance in a place where it is allowed"
  | Outside ->
      run "outside of a `proc`" "E0341"
      |> Diagnostic.here "only a `proc` can run a signal function"
      |> Diagnostic.hint "%s"
           (match in_a_test sources definition within with
           | Some hint -> hint
           | None -> outside sources within head)
  | In_task ->
      run "outside of a `proc`" "E0341"
      |> Diagnostic.here "the statements of a task cannot run signal functions"
      |> Diagnostic.hint "%s"
           (let asked = Option.value (quote sources head) ~default:"…" in
            Printf.sprintf "to read it once, write `x <- ask %s` before this, and `x` here"
              (Source.grouped asked))
      |> Diagnostic.hint
           "to run it at every instant of a task, write `mkTask (proc i -> (output, event))`"
  | In_branch condition -> of_choice "in a branch" condition
  | In_guard -> of_choice "in a guard" None
  | In_function f -> (
      let where = if f = "" then "in a function" else Printf.sprintf "in the function `%s`" f in
      let d = run where "E0343" in
      match obstacle with
      | Depends_on_start | Own_definition | Lifted ->
          Diagnostic.here
            "a function cannot run a signal function, because a signal function has state: run it \
             in a `proc`"
            d
          |> own_equation sources head e
      | Bound_here x ->
          bound x d
          |> Diagnostic.hint "%s"
               (match (f, quote sources head) with
               | "", Some h when String.equal h x.name ->
                   "use `parB` to run an array of signal functions on one input, or `parZ` to run \
                    each on its own input"
               | "", Some h ->
                   Printf.sprintf "use `mapSF %s` to run one instance for each element of an array"
                     (Source.grouped h)
               | _, _ ->
                   Printf.sprintf "turn %s into a signal function, `proc %s -> …`"
                     (if f = "" then "this" else Printf.sprintf "`%s`" f)
                     x.name))
