open Basis
open Syntax
open Surface

let shown (operator : Ir.qualified) = operator.name.text

let quote ~text (span : Span.t) =
  let sources = Source.create () in
  Source.add sources ~file:span.file text;
  Source.quote sources span

(* {1 Exponents} *)

(* The exponent 0.5, which may be written `(1 / 2)`. *)
let rec is_half (t : term) =
  match t.desc with
  | Parenthesized t -> is_half t
  | Number { digits; unit_ = None; _ } -> float_of_string_opt digits = Some 0.5
  | Expression
      (Binary
         {
           operator = { name = { text = "/"; _ }; _ };
           left = { desc = Number { digits = one; unit_ = None; _ }; _ };
           right = { desc = Number { digits = two; unit_ = None; _ }; _ };
         }) ->
      float_of_string_opt one = Some 1. && float_of_string_opt two = Some 2.
  | _ -> false

let exponent ~text ~(base : term) ~operator (right : term) =
  Diagnostic.error ~code:"E0117" ~at:right.span
    "the exponent of `%s` must be a literal whole number" (shown operator)
  |>
  if not (is_half right) then
    Diagnostic.hint
      "for other exponents, use `**`, which takes Floats without a unit; for an Int `n`, write `x \
       ** toFloat n`"
  else
    match quote ~text base.span with
    | Some base_text ->
        let fixed = "sqrt " ^ Source.grouped base_text in
        fun d ->
          Diagnostic.hint "for a square root, write `%s`" fixed d
          |> Diagnostic.write (Span.merge base.span right.span) ("(" ^ fixed ^ ")")
    | None -> Diagnostic.hint "for a square root, write `sqrt (…)`"

(* {1 Two operators} *)

(* `x > 0 and y > 0`: the word was parsed as an argument. *)
let written_in_words (operand : term) =
  let word (t : term) =
    match t.desc with
    | Variable { qualifier = None; name = { text = "and"; _ }; _ } -> Some ("and", "&&", t.span)
    | Variable { qualifier = None; name = { text = "or"; _ }; _ } -> Some ("or", "||", t.span)
    | Constructor { qualifier = None; name = { text = "AND"; _ }; _ } -> Some ("AND", "&&", t.span)
    | Constructor { qualifier = None; name = { text = "OR"; _ }; _ } -> Some ("OR", "||", t.span)
    | _ -> None
  in
  match operand.desc with Application { arguments; _ } -> List.find_map word arguments | _ -> None

(* The hint for a chain of comparisons. It quotes the middle operand if that is a variable. *)
let compared_twice first (operand : term) second =
  match operand.desc with
  | Variable { qualifier = None; name; _ } ->
      Printf.sprintf
        "compare two values at a time, and join the comparisons with `&&`: `… %s %s && %s %s …`"
        (shown first) name.text name.text (shown second)
  | _ -> "compare two values at a time: `a < b && b < c`"

(* Puts the code in backticks, doubled if the code contains one. *)
let code text =
  if String.contains text '`' then Printf.sprintf "``%s``" text else Printf.sprintf "`%s`" text

(* `0.2[m] < d && d < 0.8[m]` for a chain of comparisons *)
let both_compared ~text (left : term) first (middle : term) second (right : term) d =
  match (quote ~text left.span, quote ~text middle.span, quote ~text right.span) with
  | Some a, Some b, Some c ->
      let text = Printf.sprintf "%s %s %s && %s %s %s" a (shown first) b b (shown second) c in
      Diagnostic.hint "compare two values at a time: %s" (code text) d
      |> Diagnostic.write (Span.merge left.span right.span) text
  | Some a, Some b, _ ->
      Diagnostic.hint "compare two values at a time: `%s %s %s && %s %s …`" a (shown first) b b
        (shown second) d
  | _ -> Diagnostic.hint "%s" (compared_twice first middle second) d

(* The named operator between two comparisons, as in ``a == b `implies` c == d``, with its operands.
*)
let named_between (middle : term) =
  match middle.desc with
  | Expression (Binary { operator = { name; _ } as operator; left; right })
    when Character.is_lower name.text.[0] ->
      Some (operator, left, right)
  | _ -> None

(* The operands of a named operator in the middle of a chain may be the numbers, as for `min`, or
   the results of the comparisons, as for `implies`. *)
let compared ~text (left : term) first (middle : term) second (right : term) d =
  match named_between middle with
  | Some (({ name = { text = "implies"; _ }; _ } as operator), a, b) -> (
      let between (start : Span.t) (stop : Span.t) = quote ~text (Span.merge start stop) in
      match (between left.span a.span, between b.span right.span) with
      | Some condition, Some claim ->
          let text = Printf.sprintf "(%s) `%s` (%s)" condition (shown operator) claim in
          Diagnostic.hint "put parentheses around each comparison: %s" (code text) d
          |> Diagnostic.write (Span.merge left.span right.span) text
      | _ -> Diagnostic.hint "put parentheses around each comparison" d)
  | Some ({ name = { text = "min" | "max" | "mod" | "div"; _ }; _ }, _, _) | None ->
      both_compared ~text left first middle second right d
  | Some _ -> Diagnostic.hint "put parentheses around the part to compute first" d

let two_operators ~text ~compare left (first : Ir.qualified) middle (second : Ir.qualified) right =
  match written_in_words middle with
  | Some (word, symbol, at) ->
      Diagnostic.error ~code:"E0110" ~at "Frob has no `%s`" word
      |> Diagnostic.hint "write `%s` instead of `%s`" symbol word
      |> Diagnostic.write at symbol
  | None ->
      Diagnostic.error ~code:"E0113" ~at:second.span
        "`%s` and `%s` cannot be combined without parentheses" (shown first) (shown second)
      |> Diagnostic.label ~at:first.span "after this one"
      |>
      if compare then compared ~text left first middle second right
      else Diagnostic.hint "put parentheses around the part to compute first"

(* {1 Minus signs and sections} *)

let in_parentheses (first : Span.t) (last : Span.t) =
  let place at = Span.make ~file:first.file ~start:at ~stop:at in
  Diagnostic.fix ~safe:true "put parentheses around it"
    [ (place first.start, "("); (place last.stop, ")") ]

(* `(-x)`, if the operand is short. *)
let negated (operand : term) =
  match operand.desc with
  | Variable { qualifier = None; name; _ } -> Printf.sprintf "(-%s)" name.text
  | Number { digits; unit_ = None; _ } -> Printf.sprintf "(-%s)" digits
  | _ -> "(-x)"

let minus_after ~operator ~at (operand : term) =
  Diagnostic.error ~code:"E0113" ~at "a minus sign directly after `%s` needs parentheses"
    (shown operator)
  |> Diagnostic.hint "put it and its operand in parentheses: `x %s %s`" (shown operator)
       (negated operand)
  |> in_parentheses at operand.span

let two_minuses ~first ~second (operand : term) =
  Diagnostic.error ~code:"E0113" ~at:second "two minus signs in a row need parentheses"
  |> Diagnostic.label ~at:first "the first"
  |> in_parentheses second operand.span

let section (operator : Ir.qualified) ~inner =
  let inside = match inner with Some inner -> shown inner | None -> "-" in
  Diagnostic.error ~code:"E0113" ~at:operator.span
    "this section needs parentheses: without them, `%s` would not apply to the whole operand, \
     which contains `%s`"
    (shown operator) inside
  |> Diagnostic.hint "put parentheses around the operand of the section"
