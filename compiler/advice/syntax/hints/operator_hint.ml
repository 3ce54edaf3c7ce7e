open Syntax
open Grammar
open Found

let an_equation = "Frob has no assignments: write an equation that holds at every instant"

(* The rest of the line after this offset, without a `;`. *)
let rest_of_line found offset =
  let rest = between found offset (end_of_line found offset) in
  let n = String.length rest in
  if n > 0 && rest.[n - 1] = ';' then String.trim (String.sub rest 0 (n - 1)) else rest

(* The constant in an equation such as `y = 0.1` on a line above, in the same definition. *)
let constant_above found name =
  let first = start_of_definition found in
  let lines = String.split_on_char '\n' (between found first found.token.start.pos_bol) in
  let value line =
    let left, right =
      match String.index_opt line '=' with
      | Some i -> (String.sub line 0 i, String.sub line (i + 1) (String.length line - i - 1))
      | None -> ("", "")
    in
    if not (String.equal (String.trim left) name) then None
    else
      let value = String.trim right in
      let is_literal = function
        | '0' .. '9' | '.' | '-' | '[' | ']' | '/' | '^' | 'a' .. 'z' | 'A' .. 'Z' -> true
        | _ -> false
      in
      if
        value <> "" && String.for_all is_literal value
        && (Basis.Character.is_digit value.[0] || value.[0] = '-')
      then Some value
      else None
  in
  List.find_map value lines

(* The equation for a value that accumulates the change at every instant, as `y += x` does in a
   loop. *)
let accumulates found name change =
  match constant_above found name with
  | Some value ->
      Printf.sprintf "%s: instead of both lines, write `%s = delay %s %s %s`" an_equation name
        (Basis.Source.grouped value) name change
  | None ->
      Printf.sprintf "%s: `%s = delay 0 %s %s`, where 0 is the initial value" an_equation name name
        change

(* `y = delay 0 y + x` for `y += x`. *)
let accumulated found (operator : Layout.token) =
  let line = between found found.token.start.pos_bol operator.start.pos_cnum in
  let value = Other_notation.expression (rest_of_line found found.token.stop.pos_cnum) in
  match value with
  | Some value when line <> "" && String.for_all Basis.Character.is_name line ->
      accumulates found line
        (Printf.sprintf "%s %s" (written found operator) (Basis.Source.grouped value))
  | _ -> an_equation ^ ", as in `n = delay 0 n + 1`"

let assigns found =
  match found.before with
  | Some { token = OPERATOR "!"; _ } -> Some "use `/=` to compare for inequality"
  | Some ({ token = OPERATOR "+" | MINUS | STAR | SLASH; _ } as operator) ->
      Some (accumulated found operator)
  | Some _ | None -> None

(* A `//` at the start of a line. *)
let starts_a_comment found =
  found.token.token = SLASH
  && after found = '/'
  && between found found.token.start.pos_bol found.token.start.pos_cnum = ""

let own_operator =
  Syntax_topic.suggestion Own_operator
    "programs cannot define operators: define a function, and use it infix in backticks, as in ``a \
     `f` b``"

(* `map (\x -> x * 2) xs` for `xs .* 2`, `zipWith (\x y -> x * y) xs ys` for `xs .* ys` *)
let element_by_element found (point : Layout.token) operator =
  let left = word_before found point.start.pos_cnum in
  let right = Text_place.without_closing (rest_of_line found found.token.stop.pos_cnum) in
  let is_word text = text <> "" && String.for_all Basis.Character.is_name text in
  if not (is_word left && is_word right) then None
  else
    let text =
      if Basis.Character.is_digit right.[0] then
        Printf.sprintf "map (\\x -> x %c %s) %s" operator right left
      else if operator = '^' then Printf.sprintf "zipWith (**) %s %s" left right
      else Printf.sprintf "zipWith (%c) %s %s" operator left right
    in
    Some
      (Printf.sprintf
         "operators take numbers, not arrays: write `%s %s %s` for numbers, or `%s` for arrays" left
         (if operator = '^' && not (Basis.Character.is_digit right.[0]) then "**"
          else String.make 1 operator)
         right text)

(* The numbers around the `..` of `seeds = [1..10]`. *)
let seeds found (point : Layout.token) =
  let first = word_before found point.start.pos_cnum in
  let rec digits stop =
    if Basis.Character.is_digit (char_at found stop) then digits (stop + 1) else stop
  in
  let start = found.token.stop.pos_cnum in
  let start = if char_at found start = ' ' then start + 1 else start in
  let last = String.sub found.text start (digits start - start) in
  let is_number text = text <> "" && String.for_all Basis.Character.is_digit text in
  if is_number first && is_number last then
    Printf.sprintf "use ``%s `to` %s`` without brackets; it includes both numbers" first last
  else "use ``1 `to` 20`` without brackets; it includes both numbers"

(* `roMake (c) >> roMake (d)` *)
let combines_commands found =
  let make = "roMake (" in
  let command text =
    match (Text_place.find make text, String.rindex_opt text ')') with
    | Some i, Some j when i + String.length make < j ->
        let first = i + String.length make in
        Some (String.sub text first (j - first))
    | _ -> None
  in
  let at = found.token.start.pos_cnum in
  let before = command (between found found.token.start.pos_bol at) in
  let rest = rest_of_line found found.token.stop.pos_cnum in
  match (before, command rest) with
  | Some first, Some second when String.starts_with ~prefix:make rest ->
      Some
        (Printf.sprintf
           "to give two robot commands at once, combine them with `.`: `roMake (%s . %s)`" first
           (Text_place.without_closing second))
  | _ -> None

(* `number ("gap " ++ show gap) gap`: the name of the function, the label, and the rest of the line
   after the parentheses. *)
let joined_label found (operator : Layout.token) =
  let bol = operator.start.pos_bol in
  let before = String.sub found.text bol (operator.start.pos_cnum - bol) in
  match String.split_on_char '"' before with
  | [ head; label; rest ] when String.trim rest = "" && String.ends_with ~suffix:"(" head ->
      let head = String.trim (String.sub head 0 (String.length head - 1)) in
      let name = Text_place.ending head (String.length head) Basis.Character.is_name in
      Some (name, String.trim label)
  | _ -> None

let joined_texts found operator =
  match joined_label found operator with
  | Some ("number", label) ->
      let rest = rest_of_line found found.token.stop.pos_cnum in
      let inside = String.length (Text_place.without_closing rest) + 1 in
      let value =
        if inside < String.length rest then
          Text_place.without_closing (String.sub rest inside (String.length rest - inside))
        else ""
      in
      Printf.sprintf "`number` shows the label, the value and its unit: write `number \"%s\" %s`"
        label
        (if value = "" then "x" else value)
  | _ ->
      "strings and arrays cannot be concatenated: a string is a label, and an array has a fixed \
       size"

(* `mapE f e` or `map f xs` for `f <$> e`, if the operands are a function in parentheses or a name,
   and the rest of the line. *)
let mapped found (operator : Layout.token) =
  let text = found.text in
  let rec trimmed i = if i > 0 && is_blank (char_at found (i - 1)) then trimmed (i - 1) else i in
  let stop = trimmed operator.start.pos_cnum in
  let rec opening i depth =
    if i < operator.start.pos_bol then None
    else
      match text.[i] with
      | ')' -> opening (i - 1) (depth + 1)
      | '(' -> if depth = 1 then Some i else opening (i - 1) (depth - 1)
      | _ -> opening (i - 1) depth
  in
  let f =
    if stop > 0 && text.[stop - 1] = ')' then
      Option.map (fun first -> between found first stop) (opening (stop - 1) 0)
    else
      match word_before found stop with
      | name when Text_place.is_a_name name -> Some name
      | _ -> None
  in
  let argument = Text_place.without_closing (rest_of_line found (found.token.stop.pos_cnum + 1)) in
  let argument =
    match Text_place.find " where" argument with
    | Some i -> String.sub argument 0 i
    | None -> argument
  in
  match f with
  | Some f when argument <> "" && String.length f + String.length argument < 60 ->
      let applied name = Printf.sprintf "%s %s %s" name f (Basis.Source.grouped argument) in
      Some
        (Printf.sprintf "write `%s` for an event, or `%s` for an array" (applied "mapE")
           (applied "map"))
  | _ -> None

(* An operator from another language that starts with a Frob operator. *)
let foreign_operator found (before : Layout.token) =
  if not (is_adjacent found before) then None
  else
    match written found before ^ written found found.token with
    | "<$" when after found = '>' && mapped found before <> None -> mapped found before
    | "<$" | "<*" ->
        Some
          "use `mapE f e` to apply a function to an event's value, or `map f xs` to apply it to \
           each element of an array"
    | (".^" | ".*" | "./") as text when element_by_element found before text.[1] <> None ->
        element_by_element found before text.[1]
    | ".^" | ".*" | "./" ->
        Some
          "operators take numbers, not arrays: write `map (\\x -> x ^ 2) xs` for one array, or \
           `zipWith (*) xs ys` for two"
    | "<<" ->
        let bits = word_before found before.start.pos_cnum in
        let by = rest_of_line found found.token.stop.pos_cnum in
        let is_word text = text <> "" && String.for_all Basis.Character.is_name text in
        Some
          (if is_word bits && is_word by then
             Printf.sprintf "to shift the bits of an Int, write `shiftL %s %s`" bits by
           else "to shift the bits of an Int, write `shiftL bits n`")
    | "<>" -> Some "use `/=` to compare for inequality"
    | ">>" when combines_commands found <> None -> combines_commands found
    | ">>" | ">>=" -> Some "write each task on its own line in a `do`"
    | "++" when after found = ' ' -> Some (joined_texts found before)
    | ("++" | "--") as text ->
        let name = word_before found before.start.pos_cnum in
        let name = if name = "" then "n" else name in
        Some (accumulates found name (Printf.sprintf "%c 1" text.[0]))
    | "===" -> Some "use `==` to compare"
    | "!!" ->
        Some
          "for a constant index, use `xs ! 0`; for any index, use `at i x xs`, which returns `x` \
           if there is no such element"
    | "/*" -> Some "write a comment as `{- … -}`, or as `-- …` to the end of the line"
    | "//" -> Some "use `--` to start a comment; to divide whole numbers, use `div`"
    | ".." when names_before found "seeds" -> Some (seeds found before)
    | ".." ->
        let inside =
          match
            ( String.rindex_from_opt found.text before.start.pos_cnum '[',
              String.index_from_opt found.text before.stop.pos_cnum ']' )
          with
          | Some first, Some last when last <= end_of_line found before.stop.pos_cnum ->
              let text = between found (first + 1) last in
              String.concat "" (String.split_on_char ' ' text)
          | _ -> ""
        in
        Some (Beginnings.no_ranges inside)
    | _ -> None

let is_own_operator text = String.length text > 1 && text.[0] = '|' && is_symbol text.[1]

let foreign found =
  match found.before with
  | Some before
    when is_adjacent found before
         && is_own_operator (written found before ^ written found found.token) ->
      Some own_operator
  | before -> Option.map Syntax_topic.text (Option.bind before (foreign_operator found))

let row found =
  match (found.token.token, found.before) with
  | COMMA, Some { token = NUMBER _; _ } when names_before found "!" ->
      Some "write one `!` for each index: `m ! 0 ! 1`"
  | _ -> None

let member found =
  match (found.token.token, found.before) with
  | ARROW, Some ({ token = LOWER _; _ } as name)
    when is_adjacent found name && not (is_blank (after found)) ->
      let record = written found name in
      let field = part found (word_from found found.token.stop.pos_cnum) in
      Some
        (if field = "" then
           "use `r.speed` for a field; to read a sensor, apply its signal function, as in \
            `frontSonar i`"
         else if List.mem record [ "i"; "input"; "robot"; "this"; "self" ] then
           Printf.sprintf "to read a sensor, write `%s i`; for a field, `%s.%s`" field record field
         else
           Printf.sprintf
             "write `%s.%s` for a field; to read a sensor, apply its signal function, as in `%s i`"
             record field field)
  | _ -> None

(* `0,3[m/s]` *)
let decimal_comma found =
  match (found.token.token, found.before) with
  | COMMA, Some ({ token = NUMBER _; _ } as number)
    when is_adjacent found number && Basis.Character.is_digit (after found) ->
      let rest = rest_of_line found found.token.stop.pos_cnum in
      let is_of_a_literal c = not (List.mem c [ ' '; ')'; ','; ';' ]) in
      let rec stop i =
        if i < String.length rest && is_of_a_literal rest.[i] then stop (i + 1) else i
      in
      Some
        (Printf.sprintf "use `.` as the decimal point: `%s.%s`" (written found number)
           (String.sub rest 0 (stop 0)))
  | _ -> None

let negated found =
  match (found.token.token, found.before) with
  | OPERATOR "!", Some { token = OPERATOR "!"; _ } -> None
  | OPERATOR "!", _ when after found <> '=' ->
      let rec first i = if char_at found i = ' ' then first (i + 1) else i in
      Other_operator.negation found.text (first found.token.stop.pos_cnum)
  | _ -> None

let negation found =
  match (found.token.token, found.before) with
  | OPERATOR "!", Some { token = OPERATOR "!"; _ } -> None
  | OPERATOR "!", _ when after found <> '=' -> (
      match negated found with
      | None -> Some "to negate `b`, write `not b`"
      | Some (text, _) -> Some (Printf.sprintf "write `%s`" text))
  | _ -> None

let before_point found =
  match found.token.token with
  | OPERATOR "."
    when after found = '.'
         && String.trim
              (between found found.token.stop.pos_cnum
                 (end_of_line found found.token.stop.pos_cnum))
            = ".." ->
      Some "remove `...`: an indented line continues the line above"
  | OPERATOR "." when Basis.Character.is_digit (after found) ->
      Some "write a digit before the decimal point, as in `0.5`"
  | _ -> None

let after_point found =
  match found.before with
  | Some { token = OPERATOR "."; start; _ }
    when Basis.Character.is_digit (char_at found (start.pos_cnum - 1)) ->
      Some "write a digit after the decimal point, as in `5.0`"
  | _ -> None

let comment found =
  match found.token.token with
  | SLASH when after found = '*' && found.before = None ->
      Some "write a comment as `{- … -}`, or as `-- …` to the end of the line"
  | SLASH when starts_a_comment found -> Some "write `--` to start a comment"
  | _ -> None

let own found =
  match found.token.token with
  | BAR when is_symbol (after found) && after found <> '>' -> Some own_operator
  | _ -> None

let pipe found =
  match found.token.token with
  | BAR when after found = '>' -> (
      match Other_operator.pipeline found.text found.token.start.pos_cnum with
      | Some text -> Some (Printf.sprintf "write each function before its argument: `%s`" text)
      | None -> Some "write the function before its argument: `f x`")
  | _ -> None

(* `a | b`, a disjunction. *)
let disjunction found =
  let is_operand : Layout.token option -> bool = function
    | Some { token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | FIELD _; _ } -> true
    | Some _ | None -> false
  in
  match found.token.token with
  | BAR
    when is_blank (after found)
         && is_operand found.before && (not found.token.first)
         && (not
               (List.mem (first_word found)
                  [ "data"; "type"; "class"; "instance"; "foreign"; "param" ]))
         && (not (names_before found "::"))
         && (not (opens_with Layout.Bracket found.context))
         && (not (opens_with Layout.Brace found.context))
         && not (List.mem (first_word_of_line found) [ "match"; "with" ]) ->
      Some "write `||` between two conditions"
  | _ -> None
