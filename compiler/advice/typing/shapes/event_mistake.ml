open Basis
open Typing
open Shape_fact

let is_of name t =
  match Type.expand t with
  | Type.Data { tycon; _ } -> tycon = Environment.built_in name
  | _ -> false

let is_maybe = is_of "Maybe"

let content t =
  match Type.expand t with Type.Data { arguments = [ content ]; _ } -> Some content | _ -> None

let is_function t = match Type.expand t with Type.Function _ -> true | _ -> false

let is_plain t =
  match Type.expand t with
  | Number _ | Bool | String | Tuple _ -> true
  | Data _ -> not (Environment.is_event t || Environment.is_task t)
  | _ -> false

(* An example of a value of this type: a record expression if it is a small record, otherwise `x`.
   *)
let value words t =
  match Show.fields words t with
  | Some (constructor, fields) when List.compare_length_with fields 4 <= 0 ->
      Printf.sprintf "(%s { %s })" constructor
        (String.concat ", " (List.map (Printf.sprintf "%s = …") fields))
  | _ -> "x"

(* Is this the type of the second component of the wanted pair, given in place of the whole pair? *)
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
let after words (subject : Resolve.Ir.expr option) =
  match subject with
  | Some
      {
        desc =
          Apply
            {
              head =
                {
                  desc =
                    Apply { head = { desc = Global { name = "after"; _ }; _ }; argument = time; _ };
                  _;
                };
              _;
            };
        _;
      } ->
      Option.map Source.grouped (Show.quote words time.span)
  | _ -> None

let of_numbers found =
  Environment.is_event found
  && Option.fold (content found) ~none:false ~some:(fun t ->
         match Type.expand t with Number _ -> true | _ -> false)

(* The event and the amount it adds, for `accumHold 0 (tag e 1)`. *)
let added_up words (subject : Resolve.Ir.expr option) =
  let quoted (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote words e.span) in
  let event =
    match (Option.map Resolve.Walk.application subject, subject) with
    | Some ({ desc = Global { name = "tag"; _ }; _ }, [ e; x ]), _ -> (
        match (quoted e, quoted x) with
        | Some e, Some x -> Some (Printf.sprintf "tag %s (\\n -> n + %s)" e x)
        | _ -> None)
    | _, Some e -> Option.map (fun e -> Printf.sprintf "mapE (\\x n -> n + x) %s" e) (quoted e)
    | _, None -> None
  in
  Printf.sprintf
    "each event must carry a function of the previous value: to add up the numbers, write `%s`"
    (Option.value event ~default:"mapE (\\x n -> n + x) e")

(* `hold 2[s] b`, meant to keep a truth value true for a time. *)
let for_a_time words wanted found =
  Type.expand found = Bool
  &&
  match Option.map Type.expand (content wanted) with
  | Some (Number (_, u)) -> String.equal (Show.measure words u) "s"
  | _ -> false

let is_record words t = Show.fields words t <> None

(* Is this a record, a tuple or other data that is not an event, a task or a `Maybe`? *)
let is_thing t =
  match Type.expand t with
  | Data _ | Tuple (_ :: _) -> not (Environment.is_event t || Environment.is_task t || is_maybe t)
  | _ -> false

(* How to get a value of the wanted type from a value `x` of this type. Uses the field named after
   the wanted type, if there is one. *)
let within words t wanted =
  match (Show.fields words t, Type.expand wanted) with
  | Some (_, fields), Data { tycon; _ } when List.mem (String.uncapitalize_ascii tycon.name) fields
    ->
      "x." ^ String.uncapitalize_ascii tycon.name
  | _ -> "x"

let accumulated words ~name ~at (arguments : (Resolve.Ir.expr * Type.t) list) =
  let text (e : Resolve.Ir.expr) =
    Option.fold (Show.quote words e.span) ~none:"…" ~some:Source.grouped
  in
  match arguments with
  | [ (start, _); (f, change); (e, event) ] when Environment.is_event event && is_function change ->
      let takes_its_value =
        match Type.expand change with Function (_, result) -> is_function result | _ -> false
      in
      let event = Printf.sprintf (if takes_its_value then "mapE %s %s" else "tag %s %s") in
      let event = if takes_its_value then event (text f) (text e) else event (text e) (text f) in
      let cure = Printf.sprintf "%s %s (%s)" name (text start) event in
      Some
        (Diagnostic.error ~code:"E0301" ~at:f.span "`%s` does not take a function as an argument"
           name
        |> Diagnostic.label ~at:e.span "the event must carry it"
        |> Diagnostic.hint (Printf.sprintf "write `%s`" cure)
        |> Diagnostic.write at cure)
  | _ -> None

(* {1 Hints by the use of the event}

   Each function returns its hint if it applies. *)

let is_an_event fact = Environment.is_event fact.found
let event_wanted fact = Environment.is_event fact.wanted

(* `mergeE a b` applied to truth values, where `||` was meant. *)
let merged_truths fact =
  match fact.expected.because with
  | Parameter { callee = Some ("mergeE" | "mergeR" | "pairEvents"); _ }
    when event_wanted fact && fact.given = Bool ->
      let b = grouped fact "b" in
      Some
        (Printf.sprintf
           "for two conditions, write `a || b`; for an event, write `edge %s`, which occurs when \
            it becomes True, or `when %s`, which occurs whenever it is True"
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
      match (Show.quote fact.words other.span, source fact) with
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

(* `hold 2[s] b`, meant to keep a truth value true for a time. *)
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

(* `hold e x` for an event [e] without a value: the arguments are exchanged, and [x] is not an
   event. *)
let held_after_its_event fact =
  match (fact.expected.because, content fact.wanted) with
  | ( Parameter { callee = Some (("hold" | "dHold") as hold); position = 2; given = e :: _; _ },
      Some content )
    when is_of_nothing content && is_plain fact.found && fact.given <> Bool ->
      let start = match fact.given with Number _ -> "0" | _ -> "x0" in
      let e = Option.fold (Show.quote fact.words e.span) ~none:"e" ~some:Source.grouped in
      Some
        (Printf.sprintf
           "`%s` takes the initial value first, and then an event that carries the value: write \
            `%s %s (tag %s %s)`"
           hold hold start e (grouped fact "x"))
  | _ -> None

(* `Event e` or `tag e (Event x)`, if the value is already an event. *)
let wrapped_twice fact =
  let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote fact.words e.span) in
  let is_event_constructor (e : Resolve.Ir.expr) =
    match e.desc with Constructor { name = "Event"; module_ = "Prelude" } -> true | _ -> false
  in
  let inner (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head; argument; style = Juxtaposed } when is_event_constructor head -> Some argument
    | _ -> None
  in
  let hint (e : Resolve.Ir.expr) =
    match (e.desc, inner e) with
    | _, Some argument ->
        Option.map
          (Printf.sprintf "the content is an event already: write `%s` without `Event`")
          (Show.quote fact.words argument.span)
    | ( Apply
          {
            head =
              {
                desc = Apply { head = { desc = Global { name = "tag"; _ }; _ }; argument = e; _ };
                _;
              };
            argument;
            _;
          },
        None ) ->
        Option.bind (inner argument) (fun value ->
            match (quote e, quote value) with
            | Some e, Some value ->
                Some
                  (Printf.sprintf "`tag` makes the event: write the value alone, `tag %s %s`" e
                     value)
            | _ -> None)
    | _ -> None
  in
  match content fact.found with
  | Some found
    when event_wanted fact && Environment.is_event found
         && not (Option.fold (content fact.wanted) ~none:false ~some:Environment.is_event) -> (
      match Option.bind fact.subject hint with
      | Some text -> Some text
      | None ->
          Some
            "the value of this event is an event itself: use a value, not an event, as the last \
             argument of `tag` and as the result of the function of `mapE`")
  | _ -> None

(* The function and the event of `mapE f e`. *)
let mapped fact =
  match (Option.map Resolve.Walk.application fact.subject, fact.subject) with
  | Some ({ desc = Global { name = "mapE"; _ }; _ }, [ f; e ]), _ -> (
      match (Show.quote fact.words f.span, Show.quote fact.words e.span) with
      | Some f, Some e -> Some (Source.grouped f, Source.grouped e)
      | _ -> None)
  | _ -> None

(* The value that replaces a missing one: the initial value of `hold`, or a neutral one. *)
let default fact wanted =
  match fact.expected.because with
  | Parameter { callee = Some ("hold" | "dHold"); position = 2; given = start :: _; _ } ->
      Option.fold (Show.quote fact.words start.span) ~none:"x0" ~some:Source.grouped
  | _ -> ( match Type.expand wanted with Number _ -> "0" | Bool -> "False" | _ -> "x0")

let with_default fact start =
  match mapped fact with
  | Some (f, e) -> Printf.sprintf "mapE (fromMaybe %s . %s) %s" start f e
  | None -> Printf.sprintf "mapE (fromMaybe %s) %s" start (grouped fact "e")

(* An event whose value may be missing, where it must not be. *)
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
              "for the event that occurs when a value appears, write `edgeJust %s`; `fromMaybe %s \
               %s` is its value at every instant"
              m start m)
  | _ -> None

(* `hold` for a value that exists at every instant. *)
let held_value fact =
  match fact.expected.because with
  | Parameter { callee = Some (("hold" | "dHold") as hold); _ }
    when event_wanted fact && is_plain fact.found && fact.given <> Bool ->
      Some
        (Printf.sprintf
           "this has a value at every instant: to keep its value from the latest occurrence of an \
            event `e`, hold `tag e %s`; otherwise, remove the `%s`"
           (grouped fact "x") hold)
  | _ -> None

(* Any other value in place of an event. *)
let value_in_place_of_event fact =
  match (fact.expected.because, content fact.wanted) with
  | (Parameter _ | Field _ | Signature _ | Output _ | Branch _ | Element _), Some x
    when event_wanted fact && is_plain fact.found && fact.given <> Bool ->
      Some
        (Printf.sprintf
           "use `tag e %s`, which has this value when the event `e` occurs, or `NoEvent`"
           (value fact.words x))
  | _ -> None

(* An event without a value, that is, with `()`, where an event with a value is expected. *)
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
           "this occurs at one instant only: write `elapsed %s ()`, which is True from then on" time)
  | _ -> None

(* An event as the output of a signal function, or in a field, where a truth value is expected. *)
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
      Some (Printf.sprintf "remove the `%s`: this is an event already" f)
  | _ -> None

(* An event as the argument of a function of truth values. *)
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

(* A function applied to an event whose value has the argument's type. *)
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
  [
    merged_truths;
    other_constructor;
    compared_with_content;
    without_function;
    truth_held_for_a_time;
    wrapped_twice;
    of_a_maybe;
    held_after_its_event;
    held_value;
    value_in_place_of_event;
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

(* {1 Rules} *)

let by_its_use fact =
  let message text =
    (match fact.expected.because with
    | Value _ -> not_matched fact
    | Condition -> not_a_condition fact
    | _ -> different fact)
    |> Diagnostic.hint text
  in
  Option.map message (first hints fact)

(* `e < 0.4[m]`: an initial value with which the comparison is false until the event occurs. *)
let false_at_first fact =
  match (fact.expected.because, other_operand fact) with
  | Operand { operator; _ }, Some other -> (
      let is_on_the_left = compare fact.at.start other.span.start < 0 in
      let is_less =
        match operator with
        | "<" | "<=" -> is_on_the_left
        | ">" | ">=" -> not is_on_the_left
        | _ -> false
      in
      match other.desc with
      | Number { digits; _ } when is_less -> (
          match (float_of_string_opt digits, Show.quote fact.words other.span) with
          | Some limit, Some text when limit > 0. && String.starts_with ~prefix:digits text ->
              let unit_ =
                String.sub text (String.length digits) (String.length text - String.length digits)
              in
              Some (Printf.sprintf "%g%s" (10. *. limit) unit_)
          | _ -> None)
      | _ -> None)
  | _ -> None

let is_nothing (e : Resolve.Ir.expr option) =
  match e with Some { desc = Constructor { name = "Nothing"; _ }; _ } -> true | _ -> false

let in_a_maybe fact =
  match fact.expected.because with
  | Operand { operator = "==" | "/="; _ } when event_wanted fact && is_nothing fact.subject ->
      hinted fact "`Nothing` is a `Maybe`: for an event that does not occur, write `NoEvent`"
      |> Diagnostic.write fact.at "NoEvent"
      |> Option.some
  | Operand _ when is_maybe fact.found && false_at_first fact <> None ->
      let start = Option.get (false_at_first fact) in
      Some
        (hinted fact
           (Printf.sprintf
              "use `fromMaybe %s %s`, where `%s` replaces a missing value, so the comparison is \
               False then"
              start (grouped fact "m") start))
  | (Parameter _ | Operand _ | Output _ | Field _ | Signature _)
    when is_maybe fact.found && not (is_maybe fact.wanted) ->
      Some
        (hinted fact
           (let start = match fact.wanted with Number _ -> "0" | Bool -> "False" | _ -> "x0" in
            Printf.sprintf "use `fromMaybe %s %s`, where `%s` replaces a missing value" start
              (grouped fact "m") start))
  | _ -> None

let in_place_of_a_number fact =
  match fact.wanted with
  | Number _ when is_an_event fact && Option.fold (content fact.found) ~none:false ~some:is_maybe ->
      Some
        (hinted fact
           (Printf.sprintf
              "an event has a value only when it occurs, and this one may be missing: write `hold \
               0 (%s)`, which is 0 at first, and for a missing value"
              (with_default fact "0")))
  | Number _ when is_an_event fact && false_at_first fact <> None ->
      let start = Option.get (false_at_first fact) in
      let e = grouped fact "e" in
      Some
        (hinted fact
           (Printf.sprintf
              "an event has a value only when it occurs: write `hold %s %s` for its latest value; \
               `%s` is its value at first, with which the comparison is False"
              start e start))
  | Number _ when is_an_event fact ->
      Some
        (hinted fact
           (Printf.sprintf
              "an event has a value only when it occurs: write `hold 0 %s` for its latest value, \
               which is 0 at first%s"
              (grouped fact "e")
              (Option.fold (Array_mistake.with_each fact) ~none:""
                 ~some:(Printf.sprintf ", or `mapE %s` to compute with each value"))))
  | _ -> None

let of_a_truth fact =
  if event_wanted fact && fact.given = Bool then
    let b = grouped fact "b" in
    let carries is_it =
      match fact.wanted with
      | Data { arguments = [ value ]; _ } -> is_it (Type.expand value)
      | _ -> false
    in
    let carries_a_number = carries (function Type.Number _ -> true | _ -> false) in
    let carries_a_truth = carries (function Type.Bool -> true | _ -> false) in
    Diagnostic.error ~code:"E0301" ~at:fact.at "expected %s, found `Bool`" (expected_text fact)
    |> Diagnostic.hint
         (if carries_a_number then
            Printf.sprintf
              "use `tag (edge %s) x`, which occurs with the value of `x` when the condition \
               becomes True"
              b
          else if carries_a_truth then
            Printf.sprintf "use `tag (edge %s) True`, which occurs when it becomes True" b
          else
            Printf.sprintf
              "use `edge %s`, which occurs when it becomes True, or `when %s`, which occurs \
               whenever it is True; use `tag` to add a value"
              b b)
    |> Option.some
  else None

let operand fact =
  match (fact.expected.because, other_operand fact, fact.given) with
  | Operand { operator; _ }, Some other, (Number _ | Bool)
    when (Environment.is_event fact.wanted || is_maybe fact.wanted
         || is_record fact.words fact.expected.ty)
         && not (List.mem operator [ "=="; "/=" ] && not (is_record fact.words fact.expected.ty)) ->
      let because : Expected.reason =
        Operand
          { operator; other = Option.value fact.subject ~default:other; other_type = fact.found }
      in
      let swapped =
        Shape_fact.make fact.words ~subject:(Some other) ~at:other.span
          ~expected:(Expected.make because fact.found)
          ~found:fact.expected.ty
      in
      Option.map
        (Diagnostic.label ~at:fact.at (Printf.sprintf "this is %s" (found_text fact)))
        (first [ Record_mistake.in_place_of_a_number; in_place_of_a_number; in_a_maybe ] swapped)
  | _ -> None
