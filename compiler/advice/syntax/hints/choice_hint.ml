open Syntax
open Grammar
open Found

(* A `case` whose line ends without `of`. *)
let lacks_of found =
  match found.context with
  | (Case, { by; _ }) :: _ when by.start.pos_lnum <> found.token.start.pos_lnum ->
      let line = between found by.stop.pos_cnum (end_of_line found by.stop.pos_cnum) in
      let line =
        match String.index_opt line ':' with
        | Some colon when colon = String.length line - 1 -> String.trim (String.sub line 0 colon)
        | _ -> line
      in
      if line = "" || String.length line > 40 then None
      else Some (Printf.sprintf "end the line of the `case` with `of`: `case %s of`" line)
  | _ -> None

(* Is this the first of a pair of bars around an expression? *)
let encloses found =
  (not (is_blank (after found) || is_symbol (after found)))
  && String.contains
       (between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum))
       '|'

(* The value and the first pattern of `match s with | 0 -> …` or `match s { 0 => … }`, if the token
   is in the first branch. *)
let of_match found =
  let first = start_of_definition found in
  let before = String.sub found.text first (found.token.start.pos_cnum - first) in
  let words =
    List.filter (( <> ) "")
      (String.split_on_char ' ' (String.concat " " (String.split_on_char '\n' before)))
  in
  let rec value taken = function
    | ("with" | "{") :: rest -> Some (List.rev taken, rest)
    | "match" :: _ | [] -> None
    | word :: rest when String.length word > 1 && String.ends_with ~suffix:"{" word ->
        Some (List.rev (String.sub word 0 (String.length word - 1) :: taken), rest)
    | word :: rest -> value (word :: taken) rest
  in
  let rec after = function
    | ("match" | "case") :: rest -> (
        match after rest with None -> value [] rest | found -> found)
    | _ :: rest -> after rest
    | [] -> None
  in
  match after words with
  | Some ((_ :: _ as value), rest)
    when List.length value <= 6 && not (List.exists (fun w -> List.mem w [ "of"; "=" ]) value) ->
      let pattern =
        match (List.filter (( <> ) "|") rest, found.token.token) with
        | p :: _, _ -> p
        | [], (NUMBER _ | UPPER _ | LOWER _) -> written found found.token
        | [], BAR -> (
            let at = found.token.stop.pos_cnum in
            match String.split_on_char ' ' (between found at (end_of_line found at)) with
            | p :: _ when p <> "" -> p
            | _ -> "1")
        | [], _ -> "1"
      in
      Some
        (Printf.sprintf
           "use `case %s of`, and write each branch on a line below it, as in `%s -> …`"
           (String.concat " " value) pattern)
  | Some _ | None -> None

let matched found =
  match (found.token.token, found.before) with
  | (BAR | ARROW | DOUBLE_ARROW | NUMBER _ | UPPER _ | LOWER _ | UNDERSCORE), Some _
    when innermost_block found.context <> Of ->
      of_match found
  | _ -> None

(* The part of the line after the last `=`, `->`, `(` or `,` before the token. *)
let expression_around found =
  let bol = found.token.start.pos_bol in
  let rec start i depth =
    if i <= bol then bol
    else
      match found.text.[i - 1] with
      | ')' -> start (i - 1) (depth + 1)
      | '(' when depth > 0 -> start (i - 1) (depth - 1)
      | ('(' | ',') when depth = 0 -> i
      | '=' when is_blank (char_at found i) && is_blank (char_at found (i - 2)) -> i
      | '>' when char_at found (i - 2) = '-' -> i
      | _ -> start (i - 1) depth
  in
  let stop = end_of_line found bol in
  let rec last i depth =
    if i >= stop then stop
    else
      match found.text.[i] with
      | '(' -> last (i + 1) (depth + 1)
      | ')' -> if depth = 0 then i else last (i + 1) (depth - 1)
      | _ -> last (i + 1) depth
  in
  let first = start found.token.start.pos_cnum 0 in
  between found first (last first 0)

(* `when c then a else b` *)
let when_for_if found =
  match found.token.token with
  | THEN when not (opens_with Layout.If found.context || opens_with Layout.Then found.context) ->
      let line = expression_around found in
      Option.map (Printf.sprintf "use `%s`")
        (if String.starts_with ~prefix:"when " line then
           Other_notation.expression ("if " ^ String.sub line 5 (String.length line - 5))
         else None)
  | _ -> None

let after_value found =
  match (found.token.token, found.before) with
  | IF, Some before when (not (Parse.expects_more (Some before))) && not found.token.first ->
      let written = Other_notation.expression (expression_around found) in
      Some (Printf.sprintf "use `%s`" (Option.value written ~default:"if c then a else b"))
  | _ -> None

(* `x in [1, 2, 3]`, as in Python. *)
let membership found =
  match (found.token.token, found.before) with
  | IN, Some ({ token = LOWER _; _ } as before)
    when not (List.exists (fun (o, _) -> o = Layout.Block Let) found.context) ->
      let name = written found before in
      let rest =
        between found found.token.stop.pos_cnum (end_of_line found found.token.start.pos_cnum)
      in
      let array =
        match Other_notation.expression rest with
        | Some array -> Basis.Source.grouped array
        | None -> "xs"
      in
      Some
        (Printf.sprintf "to test whether an array contains a value, write `any (\\e -> e == %s) %s`"
           name array)
  | _ -> None

let double_arrow found =
  match (found.token.token, found.before) with
  | DOUBLE_ARROW, Some _ when innermost_block found.context = Of ->
      let bol = found.token.start.pos_bol in
      let pattern = between found bol found.token.start.pos_cnum in
      let value = between found found.token.stop.pos_cnum (end_of_line found bol) in
      Some
        (if String.length value < 60 && value <> "" then
           Printf.sprintf "use `->` in a branch: `%s -> %s`" pattern value
         else "write the branch as `pattern -> value`")
  | DOUBLE_ARROW, Some _ -> (
      (* `proc v => do` *)
      let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
      match Text_place.find "proc " line with
      | Some i when not (Other_type.mentions "->" line || String.contains line ':') ->
          Some
            (Printf.sprintf "write `->` after the input of a `proc`: `%s ->`"
               (String.trim (String.sub line i (String.length line - i))))
      | _ -> None)
  | _ -> None

let branch found =
  match (found.token.token, found.before) with
  | EQUAL, Some { token = UPPER _ | NUMBER _ | UNDERSCORE | RPAREN; _ }
    when innermost_block found.context = Of && not (in_brackets found.context) ->
      Some
        (Printf.sprintf "use `->` in a branch: `%s -> …`"
           (between found found.token.start.pos_bol found.token.start.pos_cnum))
  | _ -> None

let in_braces found =
  match (found.token.token, found.before) with
  | (NUMBER _ | LOWER _ | UPPER _ | LPAREN), Some { token = LBRACE; _ }
    when List.exists (fun (opener, _) -> opener = Layout.If) found.context ->
      let bol = found.token.start.pos_bol in
      let rec first i =
        if i < bol then None
        else if part found (word_from found i) = "if" then Some i
        else first (i - 1)
      in
      let written =
        Option.bind
          (first found.token.start.pos_cnum)
          (Other_definition.choice_in_braces found.text)
      in
      Some
        (Printf.sprintf "use `%s`, without braces"
           (Option.value written ~default:"if c then a else b"))
  | _ -> None

(* `| if x > 0 = 1` *)
let if_in_a_guard found =
  let bol = found.token.start.pos_bol in
  match
    (found.token.token, String.split_on_char ' ' (between found bol found.token.start.pos_cnum))
  with
  | EQUAL, "|" :: "if" :: (_ :: _ as condition) ->
      Some (Printf.sprintf "a guard needs no `if`: use `| %s = …`" (String.concat " " condition))
  | _ -> None

(* `| x < 0 = 1, x > 1 = 2`, and `| x > 0, x < 1 = 2` as in Haskell *)
let separated_guards found =
  let bol = found.token.start.pos_bol and at = found.token.start.pos_cnum in
  let sign = if innermost_block found.context = Of then " -> " else " = " in
  let split text =
    Option.map
      (fun i ->
        let n = String.length sign in
        (String.sub text 0 i, String.sub text (i + n) (String.length text - i - n)))
      (Text_place.find sign text)
  in
  let line = String.sub found.text bol (at - bol) in
  match (found.token.token, String.rindex_opt line '|') with
  | COMMA, Some bar
    when (not (in_brackets found.context)) && Option.is_none (Text_place.find "||" line) -> (
      let first = between found (bol + bar + 1) at in
      let rest = between found (at + 1) (end_of_line found at) in
      let is_alone name = name <> "" && String.for_all Basis.Character.is_name name in
      match (split first, split rest) with
      | _ when rest = "" -> Some "remove the comma at the end of the line"
      | _ when Other_type.mentions "<-" first || Other_type.mentions "<-" rest ->
          Some "a guard is a condition: to match a pattern, use `case`"
      | None, Some (second, value) ->
          Some
            (Printf.sprintf "join two conditions with `&&`: `| %s && %s%s%s`" first second sign
               value)
      | Some _, Some _ ->
          Some
            (Printf.sprintf "put each guard on a line of its own, without a comma: `| %s`, `| %s`"
               first rest)
      | Some (name, number), None when String.equal sign " = " && is_alone name ->
          Some
            (Printf.sprintf
               "compare with `==`, and join conditions with `&&`: `| %s == %s && %s = …`" name
               number rest)
      | _ -> None)
  | _ -> None

let otherwise found =
  match (found.token.token, found.before) with
  | ELSE, _
    when String.starts_with ~prefix:"-> "
           (String.trim
              (between found found.token.stop.pos_cnum
                 (end_of_line found found.token.stop.pos_cnum))) ->
      Some "to match all other values, write `_` instead of `else`"
  | ELSE, Some { token = BAR; _ } -> Some "write the last guard as `| otherwise`"
  | _ -> None

(* `if (c) a else b`: the condition in brackets, and the value that follows it *)
let condition_of_c found (by : Layout.origin) =
  let text = between found by.by.stop.pos_cnum found.token.start.pos_cnum in
  let rec closing i depth =
    if i >= String.length text then None
    else
      match text.[i] with
      | '(' -> closing (i + 1) (depth + 1)
      | ')' -> if depth = 1 then Some i else closing (i + 1) (depth - 1)
      | _ -> closing (i + 1) depth
  in
  if text = "" || text.[0] <> '(' then None
  else
    match closing 0 0 with
    | None -> None
    | Some last ->
        let value = String.trim (String.sub text (last + 1) (String.length text - last - 1)) in
        if value = "" then None else Some (String.sub text 1 (last - 1), value)

let without_then found =
  match (found.token.token, found.context) with
  | ELSE, (If, by) :: _ ->
      let other =
        Text_place.without_closing (Operator_hint.rest_of_line found found.token.stop.pos_cnum)
      in
      Some
        (match condition_of_c found by with
        | Some (condition, value) when other <> "" ->
            Printf.sprintf "put `then` after the condition: `if %s then %s else %s`" condition value
              other
        | _ -> "put `then` after the condition: `if c then a else b`")
  | _ -> None

(* `if c then a, b else d, e` *)
let tuple_in_a_branch found =
  match (found.token.token, found.context) with
  | COMMA, (Then, by) :: _ -> (
      let before = between found by.by.stop.pos_cnum found.token.start.pos_cnum in
      let rest = Operator_hint.rest_of_line found found.token.stop.pos_cnum in
      match (Text_place.find " then " before, Text_place.find " else " rest) with
      | Some i, Some j ->
          let first = String.sub before (i + 6) (String.length before - i - 6) in
          Some
            (Printf.sprintf "put each tuple in parentheses, as in `then (%s, %s) else …`" first
               (String.trim (String.sub rest 0 j)))
      | _ -> Some "put the tuple in parentheses: `(a, b)`")
  | _ -> None

let chain found =
  match (found.token.token, found.before) with
  | THEN, _ when opens_with Layout.Then found.context ->
      Some "use `else if`: `if a then x else if b then y else z`"
  | _ -> None

let absolute_value found =
  match (found.token.token, found.before) with
  | BAR, before when encloses found && Parse.expects_more before ->
      Some "use `abs x` for the absolute value of `x`"
  | _ -> None

let equation_before_guards found =
  match (found.token.token, found.before) with
  | BAR, Some { token = EQUAL; _ } ->
      Some "remove the `=` before the guards: each guard has its own, as in `| x > 0 = 1`"
  | _ -> None

let without_of found =
  match (found.token.token, found.before) with ARROW, _ -> lacks_of found | _ -> None

let of_assignments found =
  let first, _ = first_word_from found found.token.start.pos_bol in
  let opener =
    List.find_map
      (function
        | (Layout.If | Layout.Then), ({ by; _ } : Layout.origin) -> Some by.start.pos_cnum
        | _ -> None)
      found.context
  in
  first :: Option.to_list opener
  |> List.find_map (Other_definition.choice found.text)
  |> Option.map (Printf.sprintf "choose the value in one equation: `%s`")

(* `zone d = if | d < 1[m] -> 0 …`, guards after `if` as in an extension of Haskell. *)
let guards_after_if found =
  match (found.token.token, found.before) with
  | BAR, Some ({ token = IF; _ } as by) ->
      let bol = by.start.pos_bol in
      let head = between found bol by.start.pos_cnum in
      let rec guards start taken =
        let stop = end_of_line found start in
        let line = between found start stop in
        if start < String.length found.text && String.starts_with ~prefix:"|" line then
          match Text_place.find " -> " line with
          | Some arrow ->
              let condition = String.trim (String.sub line 0 arrow)
              and value = String.sub line (arrow + 4) (String.length line - arrow - 4) in
              guards (stop + 1) (Printf.sprintf "%s = %s" condition (String.trim value) :: taken)
          | None -> None
        else Some (List.rev taken)
      in
      let written =
        if String.ends_with ~suffix:" =" head then
          Option.map
            (fun all ->
              String.concat " " (String.trim (String.sub head 0 (String.length head - 2)) :: all))
            (guards found.token.start.pos_cnum [])
        else None
      in
      Some
        (match written with
        | Some text when String.length text < 100 ->
            Printf.sprintf "remove `if`, and write guards before the `=`: `%s`" text
        | Some _ ->
            "remove `if`, and write guards before the `=`: `f x | x > 0 = 1 | otherwise = 0`"
        | None -> "write `if c then a else if d then b else e`")
  | _ -> None
