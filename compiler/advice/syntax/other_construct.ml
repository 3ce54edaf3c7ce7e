open Basis
open Syntax
open Grammar
open Found

let span (t : Layout.token) = Build.span (t.start, t.stop)
let error found format = Diagnostic.error ~code:"E0110" ~at:(span found.token) format

let is_a_name : Layout.token option -> bool = function
  | Some { token = LOWER _ | FIELD _ | QUALIFIED_LOWER _; _ } -> true
  | Some _ | None -> false

(* The span between two offsets on the same line: the token's line or one above it. *)
let span_before found first last =
  let bol = Option.fold (String.rindex_from_opt found.text first '\n') ~none:0 ~some:succ in
  let lines = lines_between found first found.token.start.pos_cnum in
  let place offset =
    {
      found.token.start with
      pos_cnum = offset;
      pos_bol = bol;
      pos_lnum = found.token.start.pos_lnum - lines;
    }
  in
  Build.span (place first, place last)

(* {1 Definitions} *)

(* `let x = 1` at the left margin. *)
let is_a_top_let found =
  match found.token.token with
  | END | SEMICOLON -> part found (word_from found (start_of_definition found)) = "let"
  | _ -> false

let top_let found =
  if not (is_a_top_let found) then None
  else
    let bol = start_of_definition found in
    let line = first_line_of_definition found in
    let own = String.trim (String.sub line 3 (String.length line - 3)) in
    let start =
      {
        found.token.start with
        pos_bol = bol;
        pos_cnum = bol;
        pos_lnum = found.token.start.pos_lnum - lines_between found bol found.token.start.pos_cnum;
      }
    in
    let first n = Build.span (start, { start with pos_cnum = bol + n }) in
    Diagnostic.error ~code:"E0110" ~at:(first 3) "a top-level definition cannot start with `let`"
    |> Diagnostic.hint "%s"
         (if String.length own > 50 then "remove it" else Printf.sprintf "write `%s`" own)
    |> Diagnostic.fix "remove it" [ (first 4, "") ]
    |> Option.some

let word_in_backticks found =
  match (found.token.token, found.before) with
  | ( (THEN | ELSE | IF | IN | OF | WHERE | DO | CASE | LET | TYPE | DATA | MODULE | CLASS | REC),
      Some { token = BACKTICK; _ } ) ->
      Some (error found "%s" (Declaration_hint.reserved_word (written found found.token)))
  | _ -> None

(* Does the line, up to the token, contain only a name and its type? *)
let ends_a_signature found =
  let start = found.token.start.pos_bol in
  let line = String.sub found.text start (found.token.start.pos_cnum - start) in
  let has_type =
    List.exists
      (fun i -> line.[i] = ':' && line.[i + 1] = ':')
      (List.init (max 0 (String.length line - 1)) Fun.id)
  in
  has_type && not (String.exists (function '=' | '{' | '(' | '\\' -> true | _ -> false) line)

(* The name in `y :: Float`. *)
let part_name line =
  match String.split_on_char ' ' (String.trim line) with
  | name :: "::" :: _ -> Some name
  | _ -> None

let value_after_type found =
  match (found.token.token, found.before) with
  | EQUAL, Some _ when ends_a_signature found ->
      let bol = found.token.start.pos_bol in
      let name = part_name (between found bol found.token.start.pos_cnum) in
      let value = between found found.token.stop.pos_cnum (end_of_line found bol) in
      error found "expected `->` or the end of the type, found `=`"
      |> Diagnostic.hint "%s"
           (match name with
           | Some name when value <> "" && String.length value < 60 ->
               Printf.sprintf "write the definition on its own line, below its type: `%s = %s`" name
                 value
           | _ -> "write the definition on its own line, below its type")
      |> Option.some
  | _ -> None

(* `Float[m/s] v = 0.3[m/s]`, as in C *)
let type_before_equation found =
  let bol = found.token.start.pos_bol in
  let line = String.sub found.text bol (end_of_line found bol - bol) in
  match (found.token.token, Typed_equation.of_line line) with
  | (UNIT_BRACKET | LBRACKET), Some typed when found.token.start.pos_cnum - bol < typed.stop ->
      error found "an equation cannot start with a type"
      |> Diagnostic.hint "%s" (Typed_equation.advice typed)
      |> Option.some
  | _ -> None

(* {1 Choices} *)

let words_of_a_choice = [ "switch"; "match"; "when"; "select"; "if"; "cond" ]

(* The start and end of the last such word between two offsets, and the text after the word. *)
let choice_in found first last =
  let rec back i =
    if i < first then None
    else
      let ((_, stop) as word) = word_from found i in
      if
        stop < last
        && List.mem (part found word) words_of_a_choice
        && not (Basis.Character.is_name (char_at found (i - 1)))
      then Some (word, between found stop last)
      else back (i - 1)
  in
  back last

(* `switch x of` *)
let choice_with_of found =
  match (found.token.token, found.before) with
  | OF, Some _ when not (opens_with Layout.Case found.context) ->
      choice_in found found.token.start.pos_bol found.token.start.pos_cnum
  | _ -> None

(* `switch x` above `Red -> 0` *)
let choice_without_of found =
  let bol = found.token.start.pos_bol in
  match (found.token.token, found.before) with
  | ARROW, Some { token = UPPER _ | LOWER _ | NUMBER _ | UNDERSCORE | RPAREN; _ } when bol > 1 ->
      let above =
        Option.fold (String.rindex_from_opt found.text (bol - 2) '\n') ~none:0 ~some:succ
      in
      Option.bind
        (choice_in found above (bol - 1))
        (fun ((_, value) as choice) ->
          if value <> "" && String.for_all (fun c -> Basis.Character.is_name c || c = '.') value
          then Some choice
          else None)
  | _ -> None

let switch_of found =
  let choice =
    match choice_with_of found with Some it -> Some it | None -> choice_without_of found
  in
  Option.map
    (fun (((first, last) as word), value) ->
      let line_of offset =
        found.token.start.pos_lnum - lines_between found offset found.token.start.pos_cnum
      in
      let bol = Option.fold (String.rindex_from_opt found.text first '\n') ~none:0 ~some:succ in
      let place offset =
        { found.token.start with pos_cnum = offset; pos_bol = bol; pos_lnum = line_of offset }
      in
      let word = part found word in
      Diagnostic.error ~code:"E0110"
        ~at:(Build.span (place first, place last))
        "to choose by value, Frob has `case`, not `%s`" word
      |> Diagnostic.hint "write `case %s of`%s" value
           (if String.equal word "switch" then
              "; `switch` changes from one signal function to another"
            else "")
      |>
      if choice_with_of found <> None then
        Diagnostic.write (Build.span (place first, place last)) "case"
      else Fun.id)
    choice

(* {1 Loops} *)

(* `total row = for x in row` *)
let loop_as_value found =
  Option.map
    (fun ({ word; first; hint } : Other_loop.t) ->
      Diagnostic.error ~code:"E0110"
        ~at:(span_before found first (first + String.length word))
        "Frob has no `%s`" word
      |> Diagnostic.hint "%s" hint)
    (Other_loop.as_value found.text found.token.start.pos_cnum)

(* {1 Guards} *)

(* The offset of each [=] between these offsets, except in longer operators such as [==]. *)
let signs_in found first last =
  let is_one i =
    found.text.[i] = '='
    && not (is_symbol (char_at found (i - 1)) || is_symbol (char_at found (i + 1)))
  in
  List.filter is_one (List.init (max 0 (last - first)) (fun i -> first + i))

(* The offset of the `|` before the token, on its line or the line above. *)
let bar_before found =
  let is_bar i =
    found.text.[i] = '|' && is_blank (char_at found (i - 1)) && is_blank (char_at found (i + 1))
  in
  let rec back i =
    if i <= 0 || lines_between found i found.token.start.pos_cnum > 1 then None
    else if is_bar i then Some i
    else back (i - 1)
  in
  back (found.token.start.pos_cnum - 1)

let compares text =
  List.exists
    (fun word -> List.mem word [ "=="; "/="; "<"; "<="; ">"; ">="; "otherwise"; "->"; "<-" ])
    (String.split_on_char ' ' text)

let words text = List.filter (( <> ) "") (String.split_on_char ' ' text)

(* `| x = 0 = 1` or, in a branch, `| x = 0 -> 1` *)
let assignment_in_a_guard found =
  let report bar sign =
    let stop = end_of_line found sign in
    let before = String.concat " " (words (between found bar sign))
    and after = String.concat " " (words (between found (sign + 1) stop)) in
    let text = Printf.sprintf "%s == %s" before after in
    Diagnostic.error ~code:"E0110"
      ~at:(span_before found sign (sign + 1))
      "a guard cannot contain `=`"
    |> Diagnostic.hint "%s"
         (if String.length text < 60 then Printf.sprintf "to compare, write `%s`" text
          else "use `==` to compare")
    |> Diagnostic.write (span_before found sign (sign + 1)) "=="
    |> Option.some
  in
  match (found.token.token, bar_before found) with
  | EQUAL, Some bar -> (
      let at = found.token.start.pos_cnum in
      match signs_in found bar at with
      | [ sign ] when not (compares (between found bar sign)) -> report bar sign
      | []
        when innermost_block found.context = Of
             && (not (compares (between found bar at)))
             && List.mem "->" (words (between found at (end_of_line found at))) ->
          report bar at
      | _ -> None)
  | _ -> None

(* {1 `return`} *)

(* `f x = return if x > 0 then 1 else 2` *)
let value_after_return found =
  match (found.token.token, found.before) with
  | (IF | CASE), Some ({ token = LOWER "return"; _ } as return) ->
      let at = found.token.start.pos_cnum and bol = return.start.pos_bol in
      let value = between found at (end_of_line found at)
      and before = between found bol return.start.pos_cnum in
      let is_short = String.length before + String.length value < 60 in
      Some
        (if innermost_block found.context = Do then
           error found "the argument of `return` must be in parentheses"
           |> Diagnostic.hint "%s"
                (if is_short && found.token.token = IF then
                   Printf.sprintf "write `return (%s)`" value
                 else "write, for example, `return (if c then a else b)`")
         else
           Diagnostic.error ~code:"E0110" ~at:(span return) "`return` is only for tasks"
           |> Diagnostic.hint "%s"
                (if is_short && before <> "" then Printf.sprintf "write `%s %s`" before value
                 else if is_short then Printf.sprintf "write `%s`, without `return`" value
                 else "write the value without `return`")
           |> Diagnostic.fix "remove it" [ (Build.span (return.start, found.token.start), "") ])
  | _ -> None

(* {1 Haskell keywords} *)

let absent found word =
  Diagnostic.error ~code:"E0112" ~at:(span found.token) "Frob has no `%s`" word

(* The span of the word `deriving` and the classes after it: one, or several in parentheses. *)
let of_deriving found =
  let text = found.text and stop = found.token.stop.pos_cnum in
  let rec skip is i = if i < String.length text && is text.[i] then skip is (i + 1) else i in
  let is_name = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  let first = skip (Char.equal ' ') stop in
  let last =
    if first < String.length text && text.[first] = '(' then
      let close = skip (fun c -> c <> ')' && c <> '\n') first in
      if close < String.length text && text.[close] = ')' then close + 1 else stop
    else skip is_name first
  in
  let at = span found.token in
  { at with stop = Span.forward (last - stop) at.stop }

let reserved found =
  match found.token.token with
  | RESERVED "deriving" ->
      absent found "deriving"
      |> Diagnostic.hint "remove it: `==` and `<` work on all data that contains no functions"
      |> Diagnostic.fix ~safe:true "remove it" [ (of_deriving found, "") ]
      |> Option.some
  | RESERVED "newtype" ->
      absent found "newtype"
      |> Diagnostic.hint "use `data`: it has no overhead for a single field"
      |> Diagnostic.write (span found.token) "data"
      |> Option.some
  | RESERVED word -> Some (absent found word)
  | _ -> None

(* {1 Brackets} *)

(* The text before the first unmatched closing square bracket. *)
let before_closing text =
  let rec go i depth =
    if i >= String.length text then None
    else
      match text.[i] with
      | '[' | '(' -> go (i + 1) (depth + 1)
      | (']' | ')') when depth > 0 -> go (i + 1) (depth - 1)
      | ']' -> Some (String.sub text 0 i)
      | _ -> go (i + 1) depth
  in
  go 0 0

(* `[x * 2 for x in xs]`, a Python list comprehension. *)
let for_each found =
  match found.context with
  | (Bracket, { by; _ }) :: _ when found.token.token = IN -> (
      let inside = between found by.stop.pos_cnum found.token.start.pos_cnum in
      let rest =
        between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum)
      in
      match (List.rev (String.split_on_char ' ' inside), before_closing rest) with
      | x :: "for" :: element, Some xs ->
          Some (String.concat " " (List.rev element), x, String.trim xs)
      | _ -> None)
  | _ -> None

let list_comprehension found =
  Option.map
    (fun (element, x, xs) ->
      error found "Frob has no array comprehensions"
      |> Diagnostic.hint "use `map (\\%s -> %s) %s` to compute each element" x element
           (Source.grouped xs))
    (for_each found)

let no_index found = error found "a `[` directly after a name is neither an index nor an array"

(* The digits in brackets directly after a name, and the offset at which the brackets end. *)
let index found =
  let start = found.token.stop.pos_cnum in
  match String.index_from_opt found.text start ']' with
  | Some stop ->
      let inside = String.sub found.text start (stop - start) in
      if inside <> "" && String.for_all Basis.Character.is_digit inside then Some (inside, stop + 1)
      else None
  | None -> None

let array_of_c found =
  match found.token.token with
  | UNIT_BRACKET ->
      let first, _ = first_word_from found found.token.start.pos_bol in
      Option.map
        (fun hint -> error found "this declares an array as in C" |> Diagnostic.hint "%s" hint)
        (Other_definition.array found.text first)
  | _ -> None

let index_in_brackets found =
  match (found.token.token, found.before, index found) with
  | UNIT_BRACKET, Some name, Some (digits, stop) when is_a_name found.before ->
      let name = word_before found name.stop.pos_cnum in
      let whole = Build.span (found.token.start, { found.token.stop with pos_cnum = stop }) in
      no_index found
      |> Diagnostic.hint
           "write `(%s ! %s)` for an element of an array; to take a tuple apart, write an equation \
            such as `(a, b) = %s`; to pass an array as an argument, put a space before the `[`"
           name digits name
      |> Diagnostic.write whole (" ! " ^ digits)
      |> Option.some
  | _ -> None

(* The text in the brackets, if they close on this line. *)
let in_brackets found =
  let start = found.token.stop.pos_cnum in
  let stop = end_of_line found start in
  match String.index_from_opt found.text start ']' with
  | Some last when last < stop -> Some (String.sub found.text start (last - start))
  | _ -> None

(* Is the text in this bracket a unit rather than an index? *)
let holds_a_unit found =
  match in_brackets found with
  | None -> false
  | Some text ->
      let between_units = function
        | ' ' | '*' | '/' | '^' | '0' .. '9' | '(' | ')' -> ' '
        | c -> c
      in
      let words =
        List.filter (( <> ) "") (String.split_on_char ' ' (String.map between_units text))
      in
      words <> [] && List.for_all Lexer.is_unit words

(* `a[i + 1]`, with an index that is not a literal number. *)
let computed_index found =
  match (found.before, in_brackets found) with
  | Some name, Some text when is_a_name found.before && text <> "" && not (holds_a_unit found) -> (
      let name = word_before found name.stop.pos_cnum in
      match Other_notation.expression text with
      | Some ("t - 1" | "k - 1" | "n - 1") -> Some (Printf.sprintf "delay 0 %s" name)
      | Some index -> Some (Printf.sprintf "(at %s 0 %s)" (Basis.Source.grouped index) name)
      | None -> None)
  | _ -> None

let is_delayed = String.starts_with ~prefix:"delay "

let bracket_after_name found =
  match found.token.token with
  | UNIT_BRACKET when is_a_name found.before ->
      Some
        (if holds_a_unit found then
           error found "a unit in brackets can follow a literal number or a type, but not a name"
           |> Diagnostic.hint
                "remove the unit if the value already has one; to give a plain number a unit, \
                 multiply: `x * 1[m]`"
         else if Option.fold (computed_index found) ~none:false ~some:is_delayed then
           no_index found
           |> Diagnostic.hint
                "for the value one instant ago, write `%s`, where 0 is the initial value"
                (Option.get (computed_index found))
         else if computed_index found <> None then
           no_index found
           |> Diagnostic.hint
                "write `%s` for the element at a computed index; 0 is the value if there is no \
                 such element"
                (Option.get (computed_index found))
         else
           no_index found
           |> Diagnostic.hint
                "use `xs ! 0` for an element of an array; to take a tuple apart, write an equation \
                 such as `(a, b) = p`; to pass an array as an argument, put a space before the `[`")
  | _ -> None

let is_a_type text =
  text <> ""
  && Basis.Character.is_upper text.[0]
  && String.for_all Basis.Character.is_name text
  && not (Lexer.is_unit text)

let type_in_brackets found =
  match (found.token.token, found.before) with
  | LBRACKET, Some { token = DOUBLE_COLON | ARROW; _ } ->
      error found "the type of an array cannot be written in brackets"
      |> Diagnostic.hint "%s"
           (match Other_type.of_signature found.text found.token.start.pos_cnum with
           | Some signature -> "write " ^ signature
           | None ->
               "write the size and the type of the elements, as in `Array 4 Float`, or a variable \
                for any size, as in `Array n Float`")
      |> Option.some
  | LBRACKET, Some { token = UPPER _ | QUALIFIED_UPPER _; _ }
    when names_before found "::" && Option.fold (in_brackets found) ~none:false ~some:is_a_type ->
      let element = Option.get (in_brackets found) in
      error found "the type of an array cannot be written in brackets"
      |> Diagnostic.hint "%s"
           (match Other_type.of_signature found.text found.token.start.pos_cnum with
           | Some signature -> "write " ^ signature
           | None ->
               Printf.sprintf
                 "write it with a size, as in `(Array 4 %s)`, or with a variable for any size, as \
                  in `(Array n %s)`"
                 element element)
      |> Option.some
  | LBRACKET, Some { token = UPPER _ | LOWER _ | QUALIFIED_UPPER _; _ } ->
      error found "a `[` is not allowed here"
      |> Diagnostic.hint
           "write a unit directly after its type, as in `Float[m]`; write the type of an array as \
            `Array 4 Float`"
      |> Option.some
  | _ -> None

(* The rules exclude each other, with two exceptions: `index_in_brackets` is a special case of
   `bracket_after_name`, and `top_let` explains any error in a `let` at the left margin. *)
let rules =
  [
    top_let;
    loop_as_value;
    assignment_in_a_guard;
    value_after_return;
    word_in_backticks;
    list_comprehension;
    array_of_c;
    index_in_brackets;
    value_after_type;
    reserved;
    switch_of;
    type_before_equation;
    bracket_after_name;
    type_in_brackets;
  ]

let diagnostic found = List.find_map (fun rule -> rule found) rules
