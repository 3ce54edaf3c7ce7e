open Syntax
open Grammar
open Found

(* Is the enclosing `do` the body of a `proc`, and not a block of tasks? *)
let of_a_proc found =
  match innermost found.context with
  | Some (Do, { by; _ }) ->
      let line = between found by.start.pos_bol by.start.pos_cnum in
      List.mem "proc" (String.split_on_char ' ' (String.concat " " (String.split_on_char '(' line)))
  | _ -> false

(* `f (v = 1)`, a keyword argument. *)
let is_a_keyword_argument found (name : Layout.token) =
  opens_with Layout.Paren found.context
  &&
  let rec back i = if i >= 0 && char_at found i = ' ' then back (i - 1) else i in
  let opener = back (name.start.pos_cnum - 1) in
  match char_at found opener with
  | '(' -> (
      match char_at found (back (opener - 1)) with
      | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true
      | _ -> false)
  | ',' -> true
  | _ -> false

(* The name before `.speed`. *)
let record_before found (field : Layout.token) =
  match word_before found field.start.pos_cnum with "" -> "r" | name -> name

let split_by_value found =
  match found.token.token with
  | LEFT_ARROW when not (is_blank (after found)) ->
      Some "`<-` is a single symbol: to compare with a negative number, insert a space: `< -`"
  | _ -> None

let outside_do found =
  match found.token.token with
  | LEFT_ARROW when innermost_block found.context <> Do ->
      Some "use `=` in an equation; `<-` is only allowed in the statements of a `do`"
  | _ -> None

let outside_proc found =
  match found.token.token with
  | TAIL ->
      Some "in an equation, apply the signal function: `x = sf e`; `-<` is only allowed in a `proc`"
  | _ -> None

let changed found =
  match (found.token.token, found.before) with
  | EQUAL, Some before when is_adjacent found before -> Operator_hint.assigns found
  | _ -> None

let in_a_choice found =
  match (found.token.token, found.before) with
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when stands_after found "then" name || stands_after found "else" name ->
      Some
        "Frob has no assignments: choose the value in one equation, as in `x = if c then a else b`"
  | _ -> None

(* Is the token in the parameter list of a definition, as in `f(x, k=2) = …`? *)
let is_a_default_value found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  not (List.exists (fun c -> String.contains line c) [ '='; '>'; '<' ])

(* `f 1 2` for `f(x=1, y=2)`, where the token is one of the `=` signs *)
let call_without_keywords found =
  match found.context with
  | (Layout.Paren, { by; _ }) :: _ -> Other_arguments.without_keywords found.text by.start.pos_cnum
  | _ -> None

let keyword_argument found =
  match (found.token.token, found.before) with
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when is_a_keyword_argument found name && is_a_default_value found ->
      Some
        (Printf.sprintf
           "a function's parameter cannot have a default value: write only `%s`, and pass the \
            value in each call"
           (written found name))
  | EQUAL, Some ({ token = LOWER _; _ } as name) when is_a_keyword_argument found name ->
      Some
        (match call_without_keywords found with
        | Some text ->
            Printf.sprintf "arguments are passed by position, not by name: write `%s`" text
        | None -> "arguments are passed by position, not by name: write `f 1 2`")
  | _ -> None

let changed_field found =
  match (found.token.token, found.before) with
  | EQUAL, Some ({ token = FIELD field; _ } as before) ->
      Some
        (Printf.sprintf "a record cannot be changed: `%s { %s = … }` is a copy with a new `%s`"
           (record_before found before) field field)
  | _ -> None

(* The source text of the right-hand side, up to the end of the line. *)
let value_after found =
  let at = found.token.stop.pos_cnum in
  let text = String.trim (between found at (end_of_line found at)) in
  if String.length text <= 60 then text else ""

let is_a_word_part = function
  | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true
  | _ -> false

(* The function that the text applies to a name, such as `frontSonar` in `frontSonar i`. *)
let applied_to_a_name text =
  let is_a_word text = text <> "" && String.for_all is_a_word_part text in
  match String.split_on_char ' ' text with
  | [ f; x ] when is_a_word f && is_a_word x && x.[0] >= 'a' && x.[0] <= 'z' -> Some f
  | _ -> None

(* Does the text apply a function that may return a task? If not, it is a formula. *)
let applies_a_function text =
  let is_formula word =
    List.mem word [ "+"; "-"; "*"; "/"; "^"; "&&"; "||"; "=="; "/="; "<"; ">"; "<="; ">="; "!" ]
  in
  let no_task =
    [ "if"; "case"; "let"; "not"; "sqrt"; "abs"; "min"; "max"; "sin"; "cos"; "tan"; "atan2" ]
    @ [ "round"; "floor"; "ceiling"; "toFloat"; "mod"; "div"; "map"; "foldl"; "sum"; "exp"; "log" ]
  in
  let rec outside depth i =
    i >= String.length text
    ||
    match text.[i] with
    | '(' | '[' | '{' -> outside (depth + 1) (i + 1)
    | ')' | ']' | '}' -> outside (depth - 1) (i + 1)
    | ('+' | '-' | '*' | '/' | '^' | '<' | '>' | '=' | '&' | '|' | '!') when depth = 0 -> false
    | _ -> outside depth (i + 1)
  in
  match String.split_on_char ' ' text with
  | f :: _ :: _ as words ->
      f <> ""
      && Basis.Character.is_lower f.[0]
      && String.for_all Basis.Character.is_name f
      && (not (List.mem f no_task))
      && (outside 0 0 || List.hd (List.rev words) = "do" || not (List.exists is_formula words))
  | _ -> false

(* The number of iterations of a loop such as `while n < 4 …` below `n = 0`. *)
let counted_below found name =
  let at = end_of_line found found.token.start.pos_cnum in
  let rest = String.sub found.text at (String.length found.text - at) in
  let is_loop line =
    match String.split_on_char ' ' (String.trim line) with
    | "while" :: variable :: _ -> String.equal variable name
    | _ -> false
  in
  match List.find_opt is_loop (String.split_on_char '\n' rest) with
  | Some line -> Beginnings.rounds ("for " ^ String.trim line ^ ":")
  | None -> None

let statement found =
  match (found.token.token, found.before) with
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when innermost_block found.context = Do && counted_below found (written found name) <> None ->
      let rounds = Option.get (counted_below found (written found name)) in
      Some
        (Printf.sprintf
           "variables cannot change in a task: to repeat the tasks %s times, write `repeatT %s $ \
            do` instead of the `while`, and remove this line"
           rounds rounds)
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when of_a_proc found && (not (in_brackets found.context)) && value_after found <> "" ->
      Some
        (Printf.sprintf "in a `do`, write an equation with `let`: `let %s = %s`"
           (written found name) (value_after found))
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when innermost_block found.context = Do
         && (not (in_brackets found.context))
         && not (of_a_proc found) ->
      let name = written found name in
      let value = value_after found in
      let is_word = value <> "" && String.for_all is_a_word_part value in
      Some
        (match value with
        | "" ->
            Printf.sprintf
              "use `%s <- t` to run the task `t` and name its result, or `let %s = e` to name a \
               value"
              name name
        | _ when is_word && value.[0] >= 'a' && value.[0] <= 'z' ->
            Printf.sprintf
              "for the result of a task, write `%s <- %s`; for the current value of a sensor or \
               other signal function, `%s <- ask %s`; for a value, `let %s = %s`"
              name value name value name value
        (* [frontSonar i] reads a sensor, but [driveTo goal] is probably a task *)
        | _
          when applied_to_a_name value <> None
               && not (List.exists (fun x -> String.ends_with ~suffix:x value) [ " i"; " input" ])
          ->
            Printf.sprintf
              "for the result of a task, write `%s <- %s`; for a value, write `let %s = %s`" name
              value name value
        | _ when applied_to_a_name value <> None ->
            Printf.sprintf
              "for a value, write `let %s = %s`; for the current value of a sensor, `%s <- ask %s`"
              name value name
              (Option.get (applied_to_a_name value))
        | _ when applies_a_function value ->
            Printf.sprintf
              "for the result of a task, write `%s <- %s`; for a value, write `let %s = %s`" name
              value name value
        | _ ->
            Printf.sprintf
              "for a value, write `let %s = %s`; for the result of a task `t`, write `%s <- t`" name
              value name)
  | _ -> None

(* Does the text have a comma outside brackets? *)
let is_tuple text =
  let rec search i depth =
    i < String.length text
    &&
    match text.[i] with
    | '(' | '[' | '{' -> search (i + 1) (depth + 1)
    | ')' | ']' | '}' -> search (i + 1) (depth - 1)
    | ',' when depth = 0 -> true
    | _ -> search (i + 1) depth
  in
  search 0 0

(* `a, b = p`, as in Python *)
let without_parentheses found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  let names = List.map String.trim (String.split_on_char ',' line) in
  let is_name n = n <> "" && String.for_all Basis.Character.is_name n in
  match (found.token.token, names) with
  | EQUAL, _ :: _ :: _ when List.for_all is_name names ->
      let value = Operator_hint.rest_of_line found found.token.stop.pos_cnum in
      Some
        (Printf.sprintf "put a tuple pattern in parentheses: `(%s) = %s`" line
           (if value = "" || String.length value > 50 then "…"
            else if is_tuple value then "(" ^ value ^ ")"
            else value))
  | _ -> None

(* `y = z = x` *)
let two_names found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  let value = Operator_hint.rest_of_line found found.token.stop.pos_cnum in
  match (found.token.token, List.map String.trim (String.split_on_char '=' line)) with
  | EQUAL, [ first; second ]
    when List.for_all
           (fun n -> n <> "" && String.for_all Basis.Character.is_name n)
           [ first; second ]
         && value <> "" ->
      Some
        (Printf.sprintf
           "write an equation for each name, `%s = %s` and below it `%s = %s`; to compare, write \
            `==`"
           second value first second)
  | _ -> None

let comparison found =
  match found.token.token with
  | EQUAL when List.mem (first_word found) [ "test"; "trial" ] && found.before <> None ->
      let rest = Operator_hint.rest_of_line found found.token.stop.pos_cnum in
      Some (Printf.sprintf "to compare, write `== %s`" (if rest = "" then "…" else rest))
  | EQUAL when compares found.context -> Some "use `==` to compare; `=` defines a name"
  | _ -> None

(* A comma after an equation or a statement, as between the entries of a record. *)
let comma found =
  let is_outside_brackets = not (in_brackets found.context || compares found.context) in
  let follows_a_value = List.exists (names_before found) [ "="; "<-"; "-<" ] in
  match (found.token.token, innermost_block found.context) with
  | COMMA, ((Top | Where | Let | Do | Rec) as block) when is_outside_brackets && follows_a_value ->
      let stop = found.token.stop.pos_cnum in
      let what =
        match block with Do | Rec -> "statement" | Top | Let | Where | Of -> "equation"
      in
      Some
        (if between found stop (end_of_line found stop) = "" then
           Printf.sprintf "remove the comma: the line break ends the %s" what
         else Printf.sprintf "remove the comma, and write each %s on a line of its own" what)
  | _ -> None
