open Basis
open Surface

type side = Left | Right | Neither

let table =
  [
    (9, Right, [ "." ]);
    (9, Left, [ "!" ]);
    (8, Right, [ "^"; "**" ]);
    (7, Left, [ "*"; "/"; "*^"; ".&." ]);
    (6, Left, [ "+"; "-"; "^+^"; "^-^" ]);
    (5, Left, [ ".|." ]);
    (4, Neither, [ "=="; "/="; "<"; "<="; ">"; ">=" ]);
    (3, Right, [ "&&"; "***"; "&&&" ]);
    (2, Right, [ "||" ]);
    (1, Right, [ ">>>"; "<<<" ]);
    (0, Right, [ "$" ]);
  ]

let symbols = List.concat_map (fun (_, _, symbols) -> symbols) table

let precedences =
  List.concat_map
    (fun (level, side, symbols) -> List.map (fun s -> (s, (level, side))) symbols)
    table
  |> List.to_seq |> String_table.of_seq

(* Names in backticks have the precedence of [!], except for these, as in Haskell. *)
let precedence (operator : Ir.qualified) =
  match operator.name.text with
  | "shiftL" | "shiftR" -> (8, Left)
  | "div" | "mod" -> (7, Left)
  | "xor" -> (6, Left)
  | text -> Option.value (String_table.find_opt precedences text) ~default:(9, Left)

let minus_level = 6
let comparison_level = 4

type pending =
  | Binary of { left : term; operator : Ir.qualified; level : int; side : side }
  | Unary of Span.t

let shown (operator : Ir.qualified) = operator.name.text

(* The exponent 0.5, also as `(1 / 2)`. *)
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

let literal_exponent (base : term) (operator : Ir.qualified) (right : term) =
  let error span =
    Diagnostic.error ~code:"E0117" ~at:span "the exponent of `%s` must be a literal whole number"
      (shown operator)
  in
  let root quote =
    let span = Span.merge base.span right.span in
    match quote base.span with
    | Some text ->
        let cure = "sqrt " ^ Source.grouped text in
        error right.span
        |> Diagnostic.hint (Printf.sprintf "for a square root, write `%s`" cure)
        |> Diagnostic.write span ("(" ^ cure ^ ")")
    | None -> error right.span |> Diagnostic.hint "for a square root, write `sqrt (…)`"
  in
  let reject span =
    if is_half right then Reject.with_text root
    else
      Reject.diagnostic
        (error span
        |> Diagnostic.hint
             "for other exponents use `**`, which takes Floats without a unit; for an Int `n` \
              write `x ** toFloat n`")
  in
  let rec read negative (t : term) =
    match t.desc with
    | Parenthesized t -> read negative t
    | Negated t when not negative -> read true t
    | Number { digits; decimal = false; unit_ = None } -> (
        match Build.whole digits with
        | Some n -> if negative then -n else n
        | None -> reject right.span)
    | Number _ | Negated _ | Expression _ | Wildcard | As _ | Variable _ | Constructor _ | Tuple _
    | Array _ | Application _ | Braces _ ->
        reject right.span
  in
  read false right

let apply (left : term) (operator : Ir.qualified) (right : term) : term =
  let span = Span.merge left.span right.span in
  let desc : Ir.expr_desc =
    match operator with
    | { qualifier = None; name = { text = "^"; _ }; _ } ->
        let exponent = literal_exponent left operator right in
        Power { base = Term.to_expr left; exponent }
    | { qualifier = None; name = { text = "$"; _ }; _ } ->
        Apply (Term.to_expr left, Term.to_expr right)
    | _ -> Binary { operator; left = Term.to_expr left; right = Term.to_expr right }
  in
  { desc = Expression desc; span }

let negate span (operand : term) : term =
  { desc = Negated operand; span = Span.merge span operand.span }

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

(* `x < 1` and `0 < x` for a chain with a simple operand in its middle *)
let compared_twice first (operand : term) second =
  match operand.desc with
  | Variable { qualifier = None; name; _ } ->
      Printf.sprintf "compare two at a time, joined by `&&`: `… %s %s && %s %s …`" (shown first)
        name.text name.text (shown second)
  | _ -> "compare two at a time: `a < b && b < c`"

(* `0.2[m] < d && d < 0.8[m]` for a chain of comparisons *)
let both_compared (left : term) first (operand : term) second (right : term) quote d =
  match (quote left.span, quote operand.span, quote right.span) with
  | Some a, Some b, Some c ->
      let text = Printf.sprintf "%s %s %s && %s %s %s" a (shown first) b b (shown second) c in
      Diagnostic.hint (Printf.sprintf "compare two at a time: `%s`" text) d
      |> Diagnostic.write (Span.merge left.span right.span) text
  | Some a, Some b, _ ->
      Diagnostic.hint
        (Printf.sprintf "compare two at a time: `%s %s %s && %s %s …`" a (shown first) b b
           (shown second))
        d
  | _ -> Diagnostic.hint (compared_twice first operand second) d

let reject_two (left : term) (first : Ir.qualified) operand (second : Ir.qualified) right =
  match written_in_words operand with
  | Some (word, symbol, at) ->
      Reject.diagnostic
        (Diagnostic.error ~code:"E0110" ~at "Frob has no `%s`" word
        |> Diagnostic.hint (Printf.sprintf "write `%s` instead of `%s`" symbol word)
        |> Diagnostic.write at symbol)
  | None ->
      Reject.with_text (fun quote ->
          Diagnostic.error ~code:"E0113" ~at:second.span
            "`%s` and `%s` cannot be combined without parentheses" (shown first) (shown second)
          |> Diagnostic.label ~at:first.span "after this one"
          |>
          if fst (precedence second) = comparison_level then
            both_compared left first operand second right quote
          else Diagnostic.hint "put parentheses around the part to compute first")

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

let reject_minus (operator : Ir.qualified) at (operand : term) =
  Reject.diagnostic
    (Diagnostic.error ~code:"E0113" ~at "a minus sign directly after `%s` needs parentheses"
       (shown operator)
    |> Diagnostic.hint
         (Printf.sprintf "put it and its operand in parentheses: `x %s %s`" (shown operator)
            (negated operand))
    |> in_parentheses at operand.span)

(* Operator-precedence parsing with an explicit stack. [reduce] applies the operators on the stack
   that bind tighter than an operator of [level]. [right]: the operand after the operator [next]. *)
let rec reduce stack operand level side next ~right =
  match stack with
  | Binary b :: rest ->
      if b.level > level || (b.level = level && b.side = Left && side = Left) then
        reduce rest (apply b.left b.operator operand) level side next ~right
      else if b.level = level && not (b.side = Right && side = Right) then
        reject_two b.left b.operator operand next right
      else (stack, operand)
  | Unary at :: rest ->
      if minus_level > level || (minus_level = level && side = Left) then
        reduce rest (negate at operand) level side next ~right
      else (stack, operand)
  | [] -> (stack, operand)

let push stack next = function
  | Minus at ->
      (match stack with
      | Binary b :: _ when b.level >= minus_level -> reject_minus b.operator at next
      | Unary first :: _ ->
          Reject.diagnostic
            (Diagnostic.error ~code:"E0113" ~at "two minus signs in a row need parentheses"
            |> Diagnostic.label ~at:first "the first"
            |> in_parentheses at next.span)
      | Binary _ :: _ | [] -> ());
      Unary at :: stack
  | Operand { operand; operator } ->
      let level, side = precedence operator in
      let stack, left = reduce stack operand level side operator ~right:next in
      Binary { left; operator; level; side } :: stack

let rec finish stack operand =
  match stack with
  | [] -> operand
  | Binary b :: rest -> finish rest (apply b.left b.operator operand)
  | Unary at :: rest -> finish rest (negate at operand)

(* The next operand. *)
let rec next last = function
  | Operand { operand; _ } :: _ -> operand
  | Minus _ :: rest -> next last rest
  | [] -> last

let rec push_all last stack = function
  | [] -> stack
  | step :: rest -> push_all last (push stack (next last rest) step) rest

let group steps last =
  match steps with [] -> last | _ -> finish (push_all last [] (List.rev steps)) last

(* The operators left on the stack at the end are the outermost ones of the operand. The bottom one
   binds loosest. *)
let loosest stack =
  match List.rev stack with
  | [] -> None
  | Binary b :: _ -> Some (b.level, b.side, Some b.operator)
  | Unary _ :: _ -> Some (minus_level, Left, None)

let reject_section (operator : Ir.qualified) inner =
  let inside = match inner with Some inner -> shown inner | None -> "-" in
  Reject.at ~code:"E0113" operator.span ~hint:"put parentheses around the operand of the section"
    "this section needs parentheses: `%s` would take only a part of its operand with `%s`"
    (shown operator) inside

let check_section (operator : Ir.qualified) wanted stack =
  let level, side = precedence operator in
  match loosest stack with
  | None -> ()
  | Some (inner_level, inner_side, inner) ->
      if inner_level < level || (inner_level = level && not (side = wanted && inner_side = wanted))
      then reject_section operator inner

let section ~span desc : term = { desc = Expression desc; span }

let left_section ~span steps last operator =
  let stack = push_all last [] (List.rev steps) in
  check_section operator Left stack;
  section ~span (Left_section { left = Term.to_expr (finish stack last); operator })

let right_section ~span operator steps last =
  let stack = push_all last [] (List.rev steps) in
  check_section operator Right stack;
  section ~span (Right_section { operator; right = Term.to_expr (finish stack last) })

let groups_inside ~outer ~side inner =
  let outer_level, outer_side = precedence outer and level, _ = precedence inner in
  level > outer_level
  || level = outer_level
     &&
     match (side, outer_side) with
     | `Left, Left | `Right, Right -> true
     | (`Left | `Right), (Left | Right | Neither) -> false
