open Basis
open Syntax
open Grammar
open Found

let opening : Layout.opener -> (string * string) option = function
  | Paren -> Some ("(", ")")
  | Bracket -> Some ("[", "]")
  | Brace -> Some ("{", "}")
  | Block _ | If | Then | Case -> None

(* The innermost open bracket, unless a block was opened inside it. *)
let rec open_bracket : Layout.context -> ((string * string) * Layout.origin) option = function
  | (Block _, _) :: _ | [] -> None
  | (opener, by) :: rest -> (
      match opening opener with Some pair -> Some (pair, by) | None -> open_bracket rest)

(* The innermost open bracket at the end of an item, where all blocks inside the bracket have ended.
   *)
let rec bracket_of_item : Layout.context -> ((string * string) * Layout.origin) option = function
  | (Block (Let | Where | Do | Of | Rec), _) :: rest -> bracket_of_item rest
  | context -> open_bracket context

(* Are there other brackets between this one and the error, on the same line? *)
let holds_others found (opener : Lexer.token) =
  let first = opener.stop.pos_cnum in
  let length = found.token.start.pos_cnum - first in
  length > 0
  &&
  let text = String.sub found.text first length in
  String.exists (function '(' | '[' | '{' -> true | _ -> false) text
  && not (String.contains (String.trim text) '\n')

(* `P { a = x; b = 1 }`: the fix replaces each `;` in the braces. *)
let separated_by_semicolons found by =
  let open_brace = by.Layout.by.start.pos_cnum in
  let start = found.token.start in
  let comma offset =
    let at = { start with pos_cnum = offset } in
    (Build.span (at, { at with pos_cnum = offset + 1 }), ",")
  in
  let on_this_line last =
    String.contains (String.sub found.text open_brace (last - open_brace)) '\n'
  in
  (* a semicolon before the closing brace is superfluous *)
  let separator offset =
    let at, text = comma offset in
    let rec next i = if is_blank (char_at found i) then next (i + 1) else char_at found i in
    (at, if next (offset + 1) = '}' then "" else text)
  in
  let d =
    Diagnostic.error ~code:"E0111"
      ~at:(fst (comma start.pos_cnum))
      "fields are separated by `,`, not by `;`"
  in
  match Other_definition.in_braces found.text open_brace with
  | Some (inside, last) when (not (on_this_line last)) && last - open_brace < 80 ->
      let offsets =
        List.filter
          (fun i -> found.text.[i] = ';')
          (List.init (last - start.pos_cnum) (fun i -> start.pos_cnum + i))
      in
      let inside = Other_definition.without_semicolon inside in
      let commas = String.map (function ';' -> ',' | c -> c) inside in
      Diagnostic.hint "write `{ %s }`" commas d
      |> Diagnostic.fix "write commas" (List.map separator offsets)
  | Some _ | None -> Diagnostic.hint "write a `,` between fields" d |> Diagnostic.write d.at ","

(* {1 The likely place of a missing bracket} *)

(* Is there an arithmetic operator between these offsets, outside other brackets? *)
let has_operator text first last =
  let rec go i depth =
    i < last
    &&
    match text.[i] with
    | '(' | '[' -> go (i + 1) (depth + 1)
    | ')' | ']' -> go (i + 1) (depth - 1)
    | ('+' | '-' | '*' | '/') when depth = 0 && text.[i - 1] = ' ' && text.[i + 1] = ' ' -> true
    | _ -> go (i + 1) depth
  in
  go first 0

(* Finds a formula in brackets that is followed by an argument, as in `(a - b) 0`. Returns the
   offset after its `)`, and the offset of the bracket that is still open there. *)
let applied_formula text first last =
  let starts_argument i =
    i + 1 < last
    && text.[i] = ' '
    &&
    match text.[i + 1] with
    | '0' .. '9' | '(' -> true
    | 'a' .. 'z' ->
        let rec stop k = if k < last && Basis.Character.is_name text.[k] then stop (k + 1) else k in
        let word = String.sub text (i + 1) (stop (i + 1) - i - 1) in
        not (List.mem word [ "then"; "else"; "where"; "of"; "in"; "do"; "mod"; "div" ])
    | _ -> false
  in
  let rec go i opened =
    if i >= last then None
    else
      match (text.[i], opened) with
      | '(', _ -> go (i + 1) (i :: opened)
      | ')', inner :: (around :: _ as rest) ->
          if has_operator text (inner + 1) i && starts_argument (i + 1) then Some (i + 1, around)
          else go (i + 1) rest
      | ')', [ _ ] | ')', [] -> go (i + 1) []
      | _ -> go (i + 1) opened
  in
  go first []

let trimmed_end text last =
  let rec go last = if last > 0 && is_blank text.[last - 1] then go (last - 1) else last in
  go last

(* The offset at which to write the missing `)`, and the bracket that it closes; [None] if they are
   on different lines. *)
let likely_place found (by : Layout.origin) =
  let text = found.text and first = by.by.start.pos_cnum in
  let last = trimmed_end text found.token.start.pos_cnum in
  if last <= first + 1 || String.contains (String.sub text first (last - first)) '\n' then None
  else Some (Option.value (applied_formula text first last) ~default:(last, first))

let at_offset (by : Layout.origin) first last =
  let place offset = { by.by.start with pos_cnum = offset } in
  Build.span (place first, place last)

(* The line's code from the word before the opening bracket, with the missing bracket inserted. *)
let with_bracket found place opening =
  let text = found.text in
  let rec word i =
    if i > 0 && not (is_blank text.[i - 1] || text.[i - 1] = '(') then word (i - 1) else i
  in
  let before = if opening > 1 && text.[opening - 1] = ' ' then word (opening - 1) else opening in
  let before =
    if before < opening && Basis.Character.is_lower text.[before] then before else opening
  in
  let last = trimmed_end text found.token.start.pos_cnum in
  let rec closing i depth =
    if i >= last then last
    else
      match text.[i] with
      | '(' -> closing (i + 1) (depth + 1)
      | ')' -> if depth = 0 then i else closing (i + 1) (depth - 1)
      | _ -> closing (i + 1) depth
  in
  let stop = if place = last then last else closing place 0 in
  let part first last = String.sub text first (last - first) in
  part before place ^ ")" ^ part place stop

(* {1 Messages} *)

let unclosed_parenthesis found (by : Layout.origin) =
  match likely_place found by with
  | None -> None
  | Some (place, opening) ->
      let written = with_bracket found place opening in
      if String.length written > 90 then None
      else
        Some
          (Diagnostic.error ~code:"E0111"
             ~at:(at_offset by opening (opening + 1))
             "this `(` is never closed"
          |> Diagnostic.label ~at:(at_offset by place (place + 1)) "a `)` is probably missing here"
          |> Diagnostic.hint "write `%s`" written
          |> Diagnostic.fix "write the `)`" [ (at_offset by place place, ")") ])

let unclosed_bracket found ((opener, closer), by) =
  Diagnostic.error ~code:"E0111" ~at:(opener_span by) "this `%s` is never closed" opener
  |> Diagnostic.label ~at:(span found.token) "a `%s` is missing before this" closer
  |> (if holds_others found by.Layout.by && char_at found found.token.start.pos_cnum <> ';' then
        Diagnostic.hint
          "check that each bracket inside this one is closed: a `%s` closes the innermost open \
           bracket"
          closer
      else Fun.id)
  |>
  let at = found.token.start.pos_cnum in
  if at < String.length found.text && found.text.[at] = ';' then
    match opener with
    | "(" -> Diagnostic.hint "a `;` ends a definition: write each task on its own line of a `do`"
    | "[" ->
        Diagnostic.hint
          "a `;` ends a definition: write a `,` between elements, and write each row of a matrix \
           as an array, as in `[[1, 2], [3, 4]]`"
    | _ -> Fun.id
  else Fun.id

(* Is the word before the brace a constructor? *)
let is_a_record found (by : Layout.origin) =
  let word = word_before found by.by.start.pos_cnum in
  word <> "" && Basis.Character.is_upper word.[0]

(* A matrix in MATLAB's notation, such as `[1, 2; 3, 4]`. *)
let matrix found (by : Layout.origin) =
  if char_at found found.token.start.pos_cnum <> ';' then None
  else
    Option.map
      (fun text ->
        let place = found.token.start in
        Diagnostic.error ~code:"E0111"
          ~at:(Build.span (place, { place with pos_cnum = place.pos_cnum + 1 }))
          "separate array elements with `,`, not `;`"
        |> Diagnostic.hint "%s"
             (if String.starts_with ~prefix:"[[" text then
                Printf.sprintf "the rows of a matrix are arrays: write `%s`" text
              else Printf.sprintf "write `%s`" text))
      (Other_arguments.matrix found.text by.by.start.pos_cnum)

let unclosed found (((opener, _), by) as open_) =
  match opener with
  | "[" when matrix found by <> None -> Option.get (matrix found by)
  | "{" when char_at found found.token.start.pos_cnum = ';' && is_a_record found by ->
      separated_by_semicolons found by
  | "{" when Choice_hint.of_assignments found <> None ->
      Diagnostic.error ~code:"E0111" ~at:(opener_span by) "an equation cannot be in braces"
      |> Diagnostic.hint "%s" (Option.get (Choice_hint.of_assignments found))
  | "(" when char_at found found.token.start.pos_cnum <> ';' -> (
      match unclosed_parenthesis found by with Some d -> d | None -> unclosed_bracket found open_)
  | _ -> unclosed_bracket found open_

let closes_nothing found closer =
  let opener = match closer with ")" -> "(" | "]" -> "[" | _ -> "{" in
  Diagnostic.error ~code:"E0111" ~at:(span found.token) "this `%s` has no opening bracket" closer
  |> Diagnostic.hint
       "remove it, or add a `%s` before it: all other brackets in this definition are closed" opener
  |> Diagnostic.fix "remove it" [ (span found.token, "") ]

let report found =
  match found.token.token with
  | RPAREN | RBRACKET | RBRACE -> (
      let closer = written found found.token in
      match open_bracket found.context with
      | Some ((opener, right), by) when right <> closer ->
          Some
            (Diagnostic.error ~code:"E0111" ~at:(span found.token) "`%s` cannot close `%s`" closer
               opener
            |> Diagnostic.label ~at:(opener_span by) "expected `%s` to close this" right)
      | Some _ -> None
      | None ->
          if
            List.exists
              (fun (o, _) -> match opening o with Some (_, c) -> c = closer | None -> false)
              found.context
          then None
          else Some (closes_nothing found closer))
  | END when not (Parse.expects_more found.before) ->
      Option.map (unclosed found) (bracket_of_item found.context)
  | END | SEMICOLON | CLOSE | WHERE | IN | THEN | ELSE | OF ->
      Option.map (unclosed found) (open_bracket found.context)
  | _ -> None
