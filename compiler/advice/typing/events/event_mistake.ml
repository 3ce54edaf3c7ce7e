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
let is_record words t = Wording.fields words t <> None
let is_an_event fact = Environment.is_event fact.found
let event_wanted fact = Environment.is_event fact.wanted

(* The function and the event of `mapE f e`. *)
let mapped fact =
  match Option.map Resolve.Walk.application fact.subject with
  | Some ({ desc = Global { name = "mapE"; _ }; _ }, [ f; e ]) ->
      all [ Wording.argument fact.words f; Wording.argument fact.words e ]
  | _ -> None

let with_default fact start =
  match mapped fact with
  | Some [ f; e ] -> Printf.sprintf "mapE (fromMaybe %s . %s) %s" start f e
  | _ -> Printf.sprintf "mapE (fromMaybe %s) %s" start (grouped fact "e")

let accumulated words ~name ~at (arguments : (Resolve.Ir.expr * Type.t) list) =
  let text = Wording.argument_or "…" words in
  match arguments with
  | [ (start, _); (f, change); (e, event) ] when Environment.is_event event && is_function change ->
      let takes_its_value =
        match Type.expand change with Function (_, result) -> is_function result | _ -> false
      in
      let event = Printf.sprintf (if takes_its_value then "mapE %s %s" else "tag %s %s") in
      let event = if takes_its_value then event (text f) (text e) else event (text e) (text f) in
      let fixed = Printf.sprintf "%s %s (%s)" name (text start) event in
      Some
        (Diagnostic.error ~code:"E0301" ~at:f.span "`%s` does not take a function as an argument"
           name
        |> Diagnostic.label ~at:e.span "the event must carry the function"
        |> Diagnostic.hint "write `%s`" fixed
        |> Diagnostic.write at fixed)
  | _ -> None

(* Does the event come from `count`, which starts at 0? *)
let counts fact =
  match Option.map (Bare_number.value fact.words) fact.subject with
  | Some e -> Plain_name.of_head e = Some "count"
  | None -> false

(* For a comparison such as `e < 0.4[m]`: an initial value that makes the comparison false until the
   event occurs. *)
let false_at_first fact =
  match (fact.expected.because, other_operand fact) with
  | Operand { operator; _ }, Some other when not (counts fact) -> (
      let is_on_the_left = compare fact.at.start other.span.start < 0 in
      let is_less =
        match operator with
        | "<" | "<=" -> is_on_the_left
        | ">" | ">=" -> not is_on_the_left
        | _ -> false
      in
      match other.desc with
      | Number { digits; _ } when is_less -> (
          match (float_of_string_opt digits, Wording.quote fact.words other.span) with
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
           "use `fromMaybe %s %s`: if the value is missing, `%s` replaces it, and the comparison \
            is False"
           start (grouped fact "m") start)
  | (Parameter _ | Operand _ | Output _ | Field _ | Signature _)
    when is_maybe fact.found && not (is_maybe fact.wanted) ->
      Some
        (hinted fact "%s"
           (let start = match fact.wanted with Number _ -> "0" | Bool -> "False" | _ -> "x0" in
            Printf.sprintf "use `fromMaybe %s %s`, where `%s` replaces a missing value" start
              (grouped fact "m") start))
  | _ -> None

let in_place_of_a_number fact =
  match fact.wanted with
  | Number _ when is_an_event fact && Option.fold (content fact.found) ~none:false ~some:is_maybe ->
      Some
        (hinted fact
           "an event has a value only when it occurs, and even then this value may be missing: \
            write `hold 0 (%s)`, which is 0 at first and whenever the value is missing"
           (with_default fact "0"))
  | Number _ when is_an_event fact && false_at_first fact <> None ->
      let start = Option.get (false_at_first fact) in
      let e = grouped fact "e" in
      Some
        (hinted fact
           "an event has a value only when it occurs: write `hold %s %s` for its latest value; the \
            initial value `%s` makes the comparison False"
           start e start)
  | Number _ when is_an_event fact ->
      Some
        (hinted fact
           "an event has a value only when it occurs: write `hold 0 %s` for its latest value, \
            which is 0 at first%s"
           (grouped fact "e")
           (Option.fold (Array_mistake.with_each fact) ~none:""
              ~some:(Printf.sprintf ", or `mapE %s` to compute with each value")))
  | _ -> None

(* Is the value an argument of a `hold` that starts at 0 without a unit, as in `hold 0 b`? *)
let is_held_from_zero fact =
  match fact.expected.because with
  | Parameter
      {
        callee = Some ("hold" | "dHold");
        given = { desc = Number { digits = "0"; unit_ = None; _ }; _ } :: _;
        _;
      } ->
      true
  | _ -> false

(* `mapE 3 e`, where `3` was meant to replace the value of the event *)
let mapped_to_a_value fact =
  match (fact.expected.because, fact.given) with
  | ( Parameter { callee = Some "mapE"; position = 1; given = [ first; second ]; _ },
      (Number _ | Bool | String | Data _) )
    when not (Environment.is_task fact.given) -> (
      let e, x = if is_an_event fact then (first, second) else (second, first) in
      match (Wording.argument fact.words e, Wording.argument fact.words x) with
      | Some e, Some x ->
          Some
            (hinted fact
               "`mapE` applies a function to the event's value: to replace the value, write `tag \
                %s %s`"
               e x)
      | _ -> None)
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
    |> Diagnostic.hint "%s"
         (if carries_a_number && is_held_from_zero fact then
            Printf.sprintf
              "to count how often the condition becomes True, write `count (edge %s)` here; to \
               hold another value, write `tag (edge %s) x` with that value in place of `x`"
              b b
          else if carries_a_number then
            Printf.sprintf
              "use `tag (edge %s) x`, which occurs with the value of `x` when the condition \
               becomes True"
              b
          else if carries_a_truth then
            Printf.sprintf "use `tag (edge %s) True`, which occurs when the condition becomes True"
              b
          else
            Printf.sprintf
              "use `edge %s`, which occurs when the condition becomes True, or `when %s`, which \
               occurs whenever it is True; use `tag` to add a value"
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
          ~expected:{ ty = fact.found; because; parts = [] }
          ~found:fact.expected.ty
      in
      Option.map
        (Diagnostic.label ~at:fact.at "this is %s" (found_text fact))
        (first [ Record_mistake.in_place_of_a_number; in_place_of_a_number; in_a_maybe ] swapped)
  | _ -> None

(* A value of this type, if possible unlike the given ones. *)
let number_or_choice words t ~unlike =
  match (Type.expand t, Wording.choices words t) with
  | _, (_ :: _ as choices) ->
      let others = List.filter (fun choice -> not (List.mem choice unlike)) choices in
      Some (List.hd (others @ choices))
  | Type.Number (_, u), _ ->
      let unit_ = Wording.measure words (Units.resolve u) in
      Some (if String.equal unit_ "1" || Units.is_open u then "0" else Printf.sprintf "0[%s]" unit_)
  | Bool, _ -> Some (if List.mem "False" unlike then "True" else "False")
  | _ -> None

let merged fact =
  match (fact.expected.because, content fact.wanted, content fact.found) with
  | ( Parameter { callee = Some (("mergeE" | "mergeR") as name); position = 2; given = [ a; b ]; _ },
      Some wanted,
      Some found )
    when event_wanted fact && is_an_event fact -> (
      let same = "both events must carry values of the same type" in
      let tagged (e : Resolve.Ir.expr) ty ~(other : Resolve.Ir.expr) =
        let unlike =
          match Resolve.Walk.application other with
          | _, [ _; { desc = Constructor { name; _ }; _ } ] -> [ name ]
          | _ -> []
        in
        let value = Option.value (number_or_choice fact.words ty ~unlike) ~default:"x" in
        Printf.sprintf "(tag %s %s)" (Wording.argument_or "e" fact.words e) value
      in
      let text = Wording.argument_or "e" fact.words in
      let with_a_value which ty first second =
        hinted fact "%s: give the %s event a value of type %s, as in `%s %s %s`" same which
          (Wording.quoted fact.words ty) name first second
      in
      match (Type.expand wanted, Type.expand found) with
      | Tuple [], _ -> Some (with_a_value "first" found (tagged a found ~other:b) (text b))
      | _, Tuple [] -> Some (with_a_value "second" wanted (text a) (tagged b wanted ~other:a))
      | _ ->
          Some
            (hinted fact
               "%s: convert the values of one event with `mapE`, or declare a data type with a \
                case for each"
               same))
  | _ -> None
