open Basis
open Typing
open Diagnostic
open Shape_fact

let no_truth ?topic fact text =
  error ~code:"E0301" ~at:fact.at "expected `Bool`, found %s" (found_text fact)
  |> hint ?topic "%s" text

(* A comparison to suggest in place of a number. *)
let comparison fact =
  match (fact.given, fact.subject) with
  | Number _, Some { desc = Number { digits; _ }; _ } ->
      Some
        (Printf.sprintf "use `%s`: a number is not a `Bool`"
           (if float_of_string_opt digits = Some 0. then "False" else "True"))
  | Number (_, u), _ ->
      let e = raw fact "x" in
      let u = Units.resolve u in
      let text =
        if Units.equal u Units.one || Units.is_open u then Printf.sprintf "%s /= 0" e
        else Printf.sprintf "%s < 1[%s]" e (Wording.measure fact.words u)
      in
      Some
        (Printf.sprintf "a number is neither True nor False: write a comparison, as in `%s`" text)
  | _ -> None

(* The condition `b` if the subject is `edge b` or a name that is defined as such an expression. *)
let condition_of_edge fact =
  match Option.map (Bare_number.value fact.words) fact.subject with
  | Some
      { desc = Apply { head = { desc = Global { name = "edge"; _ }; _ }; argument; style = _ }; _ }
    ->
      Wording.quote fact.words argument.span
  | Some _ | None -> None

let is_now fact otherwise =
  let occurs =
    Printf.sprintf "use `isEvent %s`, which is True when the event occurs" (grouped fact otherwise)
  in
  match condition_of_edge fact with
  | Some b ->
      Printf.sprintf
        "to test whether the condition is True, write `%s`; to test whether it becomes True in \
         this instant, write `isEvent %s`"
        b (grouped fact otherwise)
  | None -> occurs

let condition fact =
  match fact.expected.because with
  | Condition ->
      let d = not_a_condition fact in
      Some
        (match comparison fact with
        | Some text -> hint "%s" text d
        | None when Environment.is_event fact.found -> (
            let d = hint "%s" (is_now fact "e") d in
            match (condition_of_edge fact, fact.subject) with
            | Some b, Some e -> write e.span (Source.grouped b) d
            | _ -> d)
        | None -> d)
  | _ -> None

(* The event function to use instead of a Boolean operator that is applied to an event. *)
let event_function fact =
  match fact.expected.because with
  | Operand { operator = "&&" | "||"; other; _ } ->
      let b = Wording.argument_or "b" fact.words other in
      Some
        (Printf.sprintf
           "%s, or `gate %s %s` for an event that occurs only while the condition is True"
           (is_now fact "e") (grouped fact "e") b)
  | Parameter { callee = Some "||"; given = [ a; b ]; _ } ->
      let text (e : Resolve.Ir.expr) name = Wording.argument_or name fact.words e in
      Some
        (Printf.sprintf "use `mergeE %s %s`, which occurs when either event does" (text a "a")
           (text b "b"))
  | Parameter { callee = Some "||"; _ } ->
      Some "use `mergeE a b`, which occurs when either event does"
  | Parameter { callee = Some "&&"; _ } ->
      Some
        "use `pairEvents a b`, which occurs when both events do, or `gate e b`, which occurs only \
         while `b` is True"
  | Parameter { callee = Some "not"; _ } -> Some (is_now fact "e")
  | _ -> None

let of_events fact =
  if fact.wanted = Bool && Environment.is_event fact.found then
    Option.map (no_truth fact) (event_function fact)
  else None

(* The hint for `not x > 0`. *)
let hint_to_group ~left name operator =
  Printf.sprintf
    "put parentheses around the argument, because function application binds tighter than `%s`: \
     `%s (%s %s …)`"
    operator name left operator

let grouped_with_an_argument fact =
  match (fact.wanted, fact.expected.because) with
  (* a function in backticks, as in "near `implies` v == 0" *)
  | ( Bool,
      Parameter
        { before = Some operator; callee = Some name; head = Some head; given = [ left; _ ]; _ } )
    when Span.compare left.span head.span < 0 && Wording.quote fact.words left.span <> None ->
      Some
        (no_truth fact
           (Printf.sprintf "put parentheses around the comparison: ``%s `%s` (%s %s …)``"
              (Option.get (Wording.quote fact.words left.span))
              name (raw fact "…") operator))
  | Bool, Parameter { before = Some operator; callee = Some name; _ } ->
      Some (no_truth ~topic:(Call name) fact (hint_to_group ~left:(raw fact "…") name operator))
  | _ -> None

(* `when frontSonar i < 1[m]`, which applies `when` to two arguments *)
let part_of_a_comparison fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | ( Bool,
      Signal_function _,
      Parameter { callee = Some name; takes = 1; position = 1; given = _ :: _ :: _ as given; _ } )
    ->
      let texts =
        List.map (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span) given
        |> List.map (Option.value ~default:"…")
      in
      Some
        (no_truth fact
           (Printf.sprintf "put parentheses around the whole argument of `%s`: `%s (%s …)`" name
              name (String.concat " " texts)))
  | _ -> None

let equal_to_a_truth fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | Bool, Number _, Operand { operator = ("==" | "/=") as operator; other; _ } ->
      let itself truth =
        let negated = Printf.sprintf "not %s" (Source.grouped truth) in
        match (raw fact "1", operator) with
        | "1", "==" | "0", "/=" -> Printf.sprintf "this is already a `Bool`: write `%s`" truth
        | "0", "==" | "1", "/=" -> Printf.sprintf "this is already a `Bool`: write `%s`" negated
        | _ -> Printf.sprintf "this is already a `Bool`: write `%s` or `%s`" truth negated
      in
      Option.map (fun truth -> no_truth fact (itself truth)) (Wording.quote fact.words other.span)
  | _ -> None

let grouped_with_an_operand fact =
  match (fact.wanted, fact.expected.because) with
  | Bool, Operand { operator; other = { desc = Apply { head; style = Juxtaposed; _ }; _ }; _ } ->
      Option.map
        (fun name -> no_truth fact (hint_to_group ~left:"…" name operator))
        (Plain_name.of_head head)
  | _ -> None

let compared fact =
  match (fact.wanted, fact.expected.because) with
  | Bool, (Parameter { before = None; _ } | Operand { other = { desc = Apply _; _ }; _ }) ->
      Option.map (no_truth fact) (comparison fact)
  | Bool, _ when match fact.subject with Some { desc = Number _; _ } -> true | _ -> false ->
      Option.map (no_truth fact) (comparison fact)
  | _ -> None

(* `delay 0 b`: the literal `0` determines the type, but `b` is a truth value. *)
let after_a_number fact =
  match fact.expected.because with
  | Parameter
      { callee = Some f; position = 2; given = [ { desc = Number _; span }; _ ]; decided_by; _ }
    when List.exists (fun (d : Expected.decider) -> Span.compare d.place span = 0) decided_by ->
      let number = Option.value (Wording.quote fact.words span) ~default:"the number" in
      Some (Printf.sprintf "`%s` is not a `Bool`: write `%s False %s`" number f (grouped fact "b"))
  | _ -> None

let in_place_of_a_number fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | Number _, Bool, Element _ -> None
  | Number (_, u), Bool, _ -> (
      match after_a_number fact with
      | Some text -> Some (hinted fact "%s" text)
      | None ->
          let one =
            if Units.is_open u || Units.equal u Units.one then "1"
            else Printf.sprintf "1[%s]" (Wording.measure fact.words u)
          in
          let text =
            match raw fact "b" with
            | "True" -> one
            | "False" -> "0"
            | b -> Printf.sprintf "(if %s then %s else 0)" b one
          in
          Some (hinted fact "a `Bool` is not a number: write `%s`" text))
  | _ -> None
