open Basis
open Typing
open Shape_fact
open Event_mistake

let is_plain t =
  match Type.expand t with
  | Number _ | Bool | String | Tuple _ -> true
  | Data _ -> not (Environment.is_event t || Environment.is_task t)
  | _ -> false

(* An example value of this type: a record expression for a small record, otherwise `x`. *)
let value words t =
  match Wording.fields words t with
  | Some (constructor, fields) when List.compare_length_with fields 4 <= 0 ->
      Printf.sprintf "(%s { %s })" constructor
        (String.concat ", " (List.map (Printf.sprintf "%s = …") fields))
  | _ -> "x"

(* Does the type match the second component of the wanted pair, rather than the whole pair? *)
let is_beside wanted found =
  match Type.expand wanted with
  | Tuple [ _; second ] -> (
      match (Type.expand second, Type.expand found) with
      | Bool, Bool -> true
      | Data { tycon; _ }, Data { tycon = other; _ } -> tycon = other
      | _ -> false)
  | _ -> false

let is_of_nothing t =
  Environment.is_event t
  && Option.fold (content t) ~none:false ~some:(fun t -> Type.expand t = Tuple [])

(* The time in `after 5[s] ()`. *)
let after words subject =
  match Option.map Resolve.Walk.application subject with
  | Some ({ desc = Global { name = "after"; _ }; _ }, [ time; _ ]) -> Wording.argument words time
  | _ -> None

let of_numbers found =
  Environment.is_event found
  && Option.fold (content found) ~none:false ~some:(fun t ->
         match Type.expand t with Number _ -> true | _ -> false)

(* The hint for an event that carries a number to be added up, as in `accumHold 0 (tag e 1)`. *)
let added_up words (subject : Resolve.Ir.expr option) =
  let quoted = Wording.argument words in
  let event =
    match (Option.map Resolve.Walk.application subject, subject) with
    | Some ({ desc = Global { name = "tag"; _ }; _ }, [ e; x ]), _ -> (
        match (quoted e, quoted x) with
        | Some e, Some x -> Some (Printf.sprintf "tag %s (\\n -> n + %s)" e x)
        | _ -> None)
    | _, Some e -> Option.map (Printf.sprintf "mapE (\\x n -> n + x) %s") (quoted e)
    | _, None -> None
  in
  Printf.sprintf
    "each event must carry a function of the previous value: to add up the numbers, write `%s`"
    (Option.value event ~default:"mapE (\\x n -> n + x) e")

(* `hold 2[s] b`, meant to keep a condition True for some time. *)
let for_a_time words wanted found =
  Type.expand found = Bool
  &&
  match Option.map Type.expand (content wanted) with
  | Some (Number (_, u)) -> String.equal (Wording.measure words u) "s"
  | _ -> false

(* Is this a record, a tuple or other data that is not an event, a task or a `Maybe`? *)
let is_thing t =
  match Type.expand t with
  | Data _ | Tuple (_ :: _) -> not (Environment.is_event t || Environment.is_task t || is_maybe t)
  | _ -> false

(* The code for a value of the wanted type, if `x` has the type `t`: the field of `x` that is named
   after the wanted type, or `x` itself if there is no such field. *)
let within words t wanted =
  match (Wording.fields words t, Type.expand wanted) with
  | Some (_, fields), Data { tycon; _ } when List.mem (String.uncapitalize_ascii tycon.name) fields
    ->
      "x." ^ String.uncapitalize_ascii tycon.name
  | _ -> "x"

(* The default for a missing value: the initial value of `hold`, or a neutral value. *)
let default fact wanted =
  match fact.expected.because with
  | Parameter { callee = Some ("hold" | "dHold"); position = 2; given = start :: _; _ } ->
      Wording.argument_or "x0" fact.words start
  | _ -> ( match Type.expand wanted with Number _ -> "0" | Bool -> "False" | _ -> "x0")

(* {1 Hints}

   Each function returns its hint, or [None] if the hint does not apply. *)

(* `isEvent` applied to a condition, as in `isEvent (bumped i)`. *)
let asked_of_a_truth fact =
  match fact.expected.because with
  | Parameter { callee = Some "isEvent"; _ } when fact.given = Bool ->
      Some
        (Printf.sprintf
           "this is already a condition: write `%s` in place of `isEvent %s`; `edge %s` is the \
            event that occurs when it becomes True"
           (raw fact "b") (grouped fact "b") (grouped fact "b"))
  | _ -> None

(* `mergeE a b` applied to conditions, where `||` was meant. *)
let merged_truths fact =
  match fact.expected.because with
  | Parameter { callee = Some ("mergeE" | "mergeR" | "pairEvents"); _ }
    when event_wanted fact && fact.given = Bool ->
      let b = grouped fact "b" in
      Some
        (Printf.sprintf
           "to combine two conditions, write `a || b`; for an event, write `edge %s`, which occurs \
            when the condition becomes True, or `when %s`, which occurs whenever it is True"
           b b)
  | _ -> None

(* The pattern `Just x` for an event, or `Event x` for a `Maybe`. *)
let other_constructor fact =
  match fact.expected.because with
  | Value _ when is_maybe fact.found && event_wanted fact ->
      Some "match an event with the patterns `Event x` and `NoEvent`"
  | Value _ when is_an_event fact && is_maybe fact.wanted ->
      Some "match a `Maybe` with the patterns `Just x` and `Nothing`"
  | _ -> None

(* An event or a `Maybe` compared with the value that it may contain. *)
let compared_with_content fact =
  match fact.expected.because with
  | Operand { operator = ("==" | "/=") as operator; other; _ }
    when (event_wanted fact || is_maybe fact.wanted) && not (is_an_event fact || is_maybe fact.found)
    -> (
      let constructor = if is_maybe fact.wanted then "Just" else "Event" in
      match (Wording.quote fact.words other.span, source fact) with
      | Some other, Some text ->
          Some
            (Printf.sprintf "compare the values like this: `%s %s %s %s`" other operator constructor
               (Source.grouped text))
      | _ -> Some (Printf.sprintf "compare it with `%s x`" constructor))
  | _ -> None

(* `accum` or a related function, with an event that does not carry a function. *)
let without_function fact =
  match fact.expected.because with
  | Parameter { callee = Some ("accum" | "accumHold" | "dAccumHold"); _ }
    when event_wanted fact && Option.fold (content fact.wanted) ~none:false ~some:is_function ->
      Some
        (if of_numbers fact.found then added_up fact.words fact.subject
         else if is_an_event fact then
           Printf.sprintf
             "each event must carry a function of the previous value, as in `tag %s (\\n -> n + \
              1)`; to count events, use `count`"
             (grouped fact "e")
         else
           "after the initial value, write an event that carries a function of the previous value, \
            as in `tag e (\\n -> n + 1)`")
  | _ -> None

(* `hold 2[s] b`, meant to keep a condition True for some time. *)
let truth_held_for_a_time fact =
  match fact.expected.because with
  | Parameter { callee = Some ("hold" | "dHold"); position = 2; _ }
    when event_wanted fact && for_a_time fact.words fact.wanted fact.found ->
      Some
        (Printf.sprintf
           "to find out if a condition was True within the last 2 seconds, write `within 2[s] %s`, \
            with `import Past`; `hold x0 e` keeps the value of an event"
           (grouped fact "b"))
  | _ -> None

(* `hold e x` for an event [e] without a value: the arguments are in the wrong order, and [x] is not
   an event. *)
let held_after_its_event fact =
  match (fact.expected.because, content fact.wanted) with
  | ( Parameter { callee = Some (("hold" | "dHold") as hold); position = 2; given = e :: _; _ },
      Some content )
    when is_of_nothing content && is_plain fact.found && fact.given <> Bool ->
      let start = match fact.given with Number _ -> "0" | _ -> "x0" in
      let e = Wording.argument_or "e" fact.words e in
      Some
        (Printf.sprintf
           "`%s` takes the initial value first, and then an event that carries the value: write \
            `%s %s (tag %s %s)`"
           hold hold start e (grouped fact "x"))
  | _ -> None

(* The argument of `Event x`. *)
let content_of_event (e : Resolve.Ir.expr) =
  match Resolve.Walk.application e with
  | { desc = Constructor { name = "Event"; module_ = "Prelude" }; _ }, [ x ] -> Some x
  | _ -> None

(* `Event e` or `tag e (Event x)`, if the value is already an event. *)
let wrapped_twice fact =
  let hint (e : Resolve.Ir.expr) =
    match (content_of_event e, Resolve.Walk.application e) with
    | Some content, _ ->
        Option.map
          (Printf.sprintf "the content is already an event: write `%s` without `Event`")
          (Wording.quote fact.words content.span)
    | None, ({ desc = Global { name = "tag"; _ }; _ }, [ e; made ]) -> (
        let value = Option.bind (content_of_event made) (Wording.argument fact.words) in
        match (Wording.argument fact.words e, value) with
        | Some e, Some value ->
            Some
              (Printf.sprintf "`tag` creates the event: pass only the value, `tag %s %s`" e value)
        | _ -> None)
    | _ -> None
  in
  let otherwise =
    "the value of this event is itself an event: use a value, not an event, as the last argument \
     of `tag` or as the result of the function that you pass to `mapE`"
  in
  match content fact.found with
  | Some found
    when event_wanted fact && Environment.is_event found
         && not (Option.fold (content fact.wanted) ~none:false ~some:Environment.is_event) ->
      Some (Option.value (Option.bind fact.subject hint) ~default:otherwise)
  | _ -> None

(* An event whose value may be missing, where a value is required. *)
let of_a_maybe fact =
  match (content fact.wanted, content fact.found) with
  | Some wanted, Some found
    when event_wanted fact && is_an_event fact && is_maybe found && not (is_maybe wanted) ->
      let start = default fact wanted in
      Some
        (Printf.sprintf
           "the value of this event may be missing: write `%s`, where `%s` replaces a missing value"
           (with_default fact start) start)
  | Some wanted, Some _
    when event_wanted fact && is_maybe fact.found
         && match fact.expected.because with Value _ | Operand _ -> false | _ -> true ->
      let start = default fact wanted in
      let m = grouped fact "m" in
      Some
        (match fact.expected.because with
        | Parameter { callee = Some ("hold" | "dHold"); _ } ->
            Printf.sprintf
              "this is a `Maybe`, not an event: write `fromMaybe %s %s`, without `hold`, where \
               `%s` replaces a missing value"
              start m start
        | _ ->
            Printf.sprintf
              "for an event that occurs when a value appears, write `edgeJust %s`; for a value at \
               every instant, write `fromMaybe %s %s`"
              m start m)
  | _ -> None

(* `hold` applied to a value that exists at every instant. *)
let held_value fact =
  match fact.expected.because with
  | Parameter { callee = Some (("hold" | "dHold") as hold); given; _ }
    when event_wanted fact && is_plain fact.found && fact.given <> Bool ->
      let start =
        match given with x0 :: _ :: _ -> Wording.argument_or "x0" fact.words x0 | _ -> "x0"
      in
      Some
        (Printf.sprintf
           "this has a value at every instant: to keep its value from the latest occurrence of an \
            event `e`, write `%s %s (tag e %s)`; otherwise, remove the `%s`"
           hold start (grouped fact "x") hold)
  | _ -> None

(* Any other value in place of an event. *)
let value_in_place_of_event fact =
  match (fact.expected.because, content fact.wanted) with
  | (Parameter _ | Field _ | Signature _ | Output _ | Branch _ | Element _), Some x
    when event_wanted fact && is_plain fact.found && fact.given <> Bool ->
      Some
        (Diagnostic.suggestion ~topic:(Call "tag")
           "use `tag e %s`, which occurs with this value when the event `e` occurs, or `NoEvent`, \
            which never occurs"
           (value fact.words x))
  | _ -> None

(* An event that carries only `()`, where an event with a value is expected. *)
let without_value fact =
  match fact.expected.because with
  | (Parameter _ | Signature _ | Output _ | Branch _)
    when is_of_nothing fact.found && event_wanted fact
         && Option.map Type.expand (content fact.wanted) = Some Bool ->
      Some
        (Printf.sprintf "the value of this event is `()`: for the value True, write `tag %s True`"
           (grouped fact "e"))
  | (Parameter _ | Signature _ | Output _ | Branch _)
    when is_of_nothing fact.found && event_wanted fact
         && Option.fold (content fact.wanted) ~none:false ~some:is_plain ->
      Some
        (Printf.sprintf
           "the value of this event is `()`: write `tag %s x` for an event with the value of `x`"
           (grouped fact "e"))
  | _ -> None

(* `if after 5[s] () then …`, where the condition was meant to stay True. *)
let time_as_condition fact =
  match (fact.expected.because, after fact.words fact.subject) with
  | (Condition | Output _ | Signature _ | Operand _), Some time
    when is_an_event fact && fact.wanted = Bool ->
      Some
        (Printf.sprintf
           "this occurs at only one instant: write `elapsed %s ()`, which is True from then on" time)
  | _ -> None

(* An event as the output of a signal function, or in a field, where a `Bool` is expected. *)
let event_in_place_of_a_truth fact =
  match fact.expected.because with
  | (Output _ | Field _ | Branch _) when is_an_event fact && fact.wanted = Bool ->
      Some
        (Printf.sprintf "use `isEvent %s`, which is True when the event occurs" (grouped fact "e"))
  | _ -> None

(* `()` or a `Maybe` as a condition. *)
let content_as_condition fact =
  match fact.expected.because with
  | Condition when fact.given = Tuple [] ->
      Some "`()` carries no information: write a condition, such as `x > 0`"
  | Condition when is_maybe fact.found && Option.map Type.expand (content fact.found) = Some Bool ->
      Some
        (Printf.sprintf
           "use `fromMaybe False %s`, which is False for `Nothing`, for example after a timeout"
           (grouped fact "m"))
  | _ -> None

(* `edge e`, where [e] is already an event. *)
let made_twice fact =
  match fact.expected.because with
  | Parameter { callee = Some (("edge" | "when" | "falling") as f); _ } when is_an_event fact ->
      Some (Printf.sprintf "remove the `%s`: this is already an event" f)
  | _ -> None

(* An event as the argument of a function that takes a `Bool`. *)
let in_place_of_a_truth fact =
  match fact.expected.because with
  | Parameter { callee = Some f; _ }
    when fact.wanted = Bool && is_an_event fact && not (List.mem f [ "&&"; "||"; "not" ]) ->
      Some
        (Printf.sprintf "use `isEvent %s`, which is True when the event occurs" (grouped fact "e"))
  | _ -> None

(* The event that ends a mode, without the mode's output. *)
let without_output fact =
  match fact.expected.because with
  | Output (Parameter { position = 1; _ }) when is_beside fact.wanted fact.found ->
      Some
        (Printf.sprintf "write the output and the event as a pair: `(output, %s)`" (raw fact "…"))
  | _ -> None

(* A function applied to an event whose value has the type of the function's parameter. *)
let applied_to_an_event fact =
  match (fact.expected.because, content fact.found) with
  | Parameter { callee = Some f; takes; _ }, Some content
    when is_an_event fact && is_thing fact.wanted
         && not (List.mem f [ "switch"; "dSwitch"; "mkTask"; "."; "map" ]) ->
      Some
        (Printf.sprintf
           "an event has a value only when it occurs: write `mapE (\\x -> %s %s%s) %s` for an \
            event with the result of `%s`"
           f
           (within fact.words content fact.wanted)
           (if takes > 1 then " …" else "")
           (grouped fact "e") f)
  | _ -> None

(* A variable whose value is `()`, because it comes from an event. *)
let value_is_nothing fact =
  match (fact.expected.because, fact.subject) with
  | (Parameter _ | Operand _ | Branch _), Some { desc = Local _; _ }
    when fact.given = Tuple [] && not (event_wanted fact) ->
      Some
        "the events of `edge`, `when` and `after` have the value `()`: write `tag e x` for an \
         event with the value of `x`"
  | _ -> None

(* The first hint that applies is used. A hint about a prelude function comes before the general one
   about parameters: `held_value` before `value_in_place_of_event`, and `made_twice` before
   `in_place_of_a_truth`. *)
let hints =
  let texts rules =
    let rule rule fact = Option.map (Diagnostic.suggestion "%s") (rule fact) in
    List.map rule rules
  in
  texts
    [
      merged_truths;
      asked_of_a_truth;
      other_constructor;
      compared_with_content;
      without_function;
      truth_held_for_a_time;
      wrapped_twice;
      of_a_maybe;
      held_after_its_event;
      held_value;
    ]
  @ [ value_in_place_of_event ]
  @ texts
      [
        without_value;
        time_as_condition;
        event_in_place_of_a_truth;
        content_as_condition;
        made_twice;
        in_place_of_a_truth;
        without_output;
        applied_to_an_event;
        value_is_nothing;
      ]

let mistake fact =
  let message hint =
    (match fact.expected.because with
    | Value _ -> not_matched fact
    | Condition -> not_a_condition fact
    | _ -> different fact)
    |> Diagnostic.suggest hint
  in
  Option.map message (first hints fact)
