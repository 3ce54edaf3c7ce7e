open Basis

type unit_ = { number : string; measure : string; whole : Span.t; is_first : bool }

let line_of text (span : Span.t) =
  Option.value
    (List.nth_opt (String.split_on_char '\n' text) (Span.line span.start - 1))
    ~default:""

let on_line (span : Span.t) first last =
  let line = Span.line span.start in
  Span.make ~file:span.file
    ~start:(Span.position ~line ~column:(first + 1))
    ~stop:(Span.position ~line ~column:(last + 1))

let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'

(* Starting at this index, skips characters that satisfy [is], forward or backward. *)
let rec forward is text i = if is (char_at text i) then forward is text (i + 1) else i
let rec backward is text i = if is (char_at text (i - 1)) then backward is text (i - 1) else i
let is_of_a_unit c = Character.is_name c || c = '/' || c = '*' || c = '^'
let is_of_a_name c = Character.is_name c || c = '.'
let is_of_a_number c = Character.is_digit c || c = '.'

let words_of measure =
  let separate = function '/' | '*' | '^' | '0' .. '9' -> ' ' | c -> c in
  List.filter (( <> ) "") (String.split_on_char ' ' (String.map separate measure))

let unit_after_number ~text ~is_unit (span : Span.t) =
  let line = line_of text span in
  let at = Span.column span.start - 1 in
  let first = backward is_of_a_unit line at in
  let last = forward is_of_a_unit line first in
  let blank = backward (Char.equal ' ') line first in
  let start = backward is_of_a_number line blank in
  let measure = String.sub line first (max 0 (last - first)) in
  if
    blank < first && start < blank
    && (not (Character.is_name (char_at line (start - 1))))
    && Character.is_name (char_at line (last - 1))
    && List.for_all is_unit (words_of measure)
  then
    let number = String.sub line start (blank - start) in
    Some { number; measure; whole = on_line span start last; is_first = first = at }
  else None

let number_with_unit ~text (span : Span.t) =
  let line = line_of text span in
  let opening = Span.column span.start - 2 and closing = Span.column span.stop - 1 in
  let start = backward is_of_a_number line opening in
  if
    char_at line opening = '['
    && char_at line closing = ']'
    && start < opening
    && not (Character.is_name (char_at line (start - 1)))
  then Some (String.sub line start (opening - start), on_line span start (closing + 1))
  else None

let before ~text (span : Span.t) = char_at (line_of text span) (Span.column span.start - 2)
let after ~text (span : Span.t) = char_at (line_of text span) (Span.column span.stop - 1)

let follows ~text before (span : Span.t) =
  let line = line_of text span and at = Span.column span.start - 1 in
  let first = at - String.length before in
  first >= 0
  && at <= String.length line
  && String.equal (String.sub line first (String.length before)) before

let is_index ~text (span : Span.t) =
  let line = line_of text span in
  let stop = forward (Char.equal ' ') line (Span.column span.stop - 1) in
  let minus = char_at line stop = '-' in
  let digit = forward (Char.equal ' ') line (stop + 1) in
  let bracket = char_at line (Span.column span.start - 2) in
  Span.column span.stop - Span.column span.start = 1
  && minus
  && Character.is_digit (char_at line digit)
  && List.mem bracket [ '('; '[' ]
  && Character.is_name (char_at line (Span.column span.start - 3))

let starts_an_equation ~text name =
  let is_it line = String.starts_with ~prefix:(name ^ " = ") (String.trim line) in
  List.exists is_it (String.split_on_char '\n' text)

let call ~text (span : Span.t) =
  let line = line_of text span in
  let first = Span.column span.start - 1 and opening = Span.column span.stop - 1 in
  let rec close i depth =
    match char_at line i with
    | '\000' -> None
    | '(' -> close (i + 1) (depth + 1)
    | ')' -> if depth = 1 then Some (i + 1) else close (i + 1) (depth - 1)
    | _ -> close (i + 1) depth
  in
  if char_at line opening <> '(' then None
  else
    let open Basis.Let_syntax.Option in
    let* stop = close opening 0 in
    let* written = Other_notation.expression (String.sub line first (stop - first)) in
    let name = String.sub line first (opening - first) in
    if String.equal written name || String.starts_with ~prefix:(name ^ " ") written then None
    else Some (on_line span first stop, written)

let lower_case name =
  let is_capital c = Character.is_upper c || Character.is_digit c || c = '_' in
  if not (String.for_all is_capital name) then String.uncapitalize_ascii name
  else
    match String.split_on_char '_' (String.lowercase_ascii name) with
    | first :: rest -> String.concat "" (first :: List.map String.capitalize_ascii rest)
    | [] -> name

let field ~text (span : Span.t) =
  let line = line_of text span in
  let point = Span.column span.stop - 1 in
  let stop = forward Character.is_name line (point + 1) in
  if char_at line point = '.' && stop > point + 1 then
    Some (on_line span (Span.column span.start - 1) stop)
  else None

let member ~text (span : Span.t) =
  let line = line_of text span in
  let point = Span.column span.stop - 1 in
  let stop = forward is_of_a_name line point in
  if char_at line point = '.' && stop > point + 1 then
    Some (on_line span (Span.column span.start - 1) stop)
  else None

let written ~text (span : Span.t) =
  let first = Span.column span.start - 1 in
  String.sub (line_of text span) first (Span.column span.stop - 1 - first)

let without_modules module_ text =
  let prefix = module_ ^ "." in
  let n = String.length prefix in
  let rec go i =
    if i >= String.length text then ""
    else
      let stop = forward is_of_a_name text i in
      let word = String.sub text i (stop - i) in
      if stop = i then String.make 1 text.[i] ^ go (i + 1)
      else if String.starts_with ~prefix word then
        let member = String.sub word n (String.length word - n) in
        Option.value (Other_function.alone member) ~default:member ^ go stop
      else word ^ go stop
  in
  go 0

let is_an_argument ~text (span : Span.t) =
  let line = line_of text span in
  let at = Span.column span.start - 1 in
  let stop = backward (Char.equal ' ') line at in
  let first = backward Character.is_name line stop in
  let word = String.sub line first (stop - first) in
  stop < at
  && (char_at line (stop - 1) = ')'
     || word <> ""
        && not (List.mem word [ "if"; "then"; "else"; "of"; "in"; "let"; "case"; "not" ]))

(* The line up to the first closing bracket whose opening bracket is on an earlier line. *)
let before_outer_bracket line =
  let rec stop i depth =
    if i >= String.length line then i
    else
      match line.[i] with
      | '(' | '[' | '{' -> stop (i + 1) (depth + 1)
      | ')' | ']' | '}' -> if depth = 0 then i else stop (i + 1) (depth - 1)
      | _ -> stop (i + 1) depth
  in
  String.sub line 0 (stop 0 0)

let equation ~text (span : Span.t) =
  let line = String.trim (before_outer_bracket (line_of text span)) in
  let start = forward Character.is_name line 0 in
  let sign = forward (Char.equal ' ') line start in
  let is_last = not (String.contains line ';') in
  if
    start > 0
    && Span.column span.start - 1 = String.index_from (line_of text span) 0 line.[0]
    && char_at line sign = '='
    && char_at line (sign + 1) = ' '
    && String.length line < 80
    && is_last
  then Some (String.sub line 0 start ^ " " ^ String.sub line sign (String.length line - sign))
  else None

let definition ~text (span : Span.t) =
  let starts line = line <> "" && Character.is_lower line.[0] in
  let lines = String.split_on_char '\n' text in
  let line = Span.line span.start in
  let before = List.filteri (fun i _ -> i < line) lines in
  let after = List.filteri (fun i _ -> i >= line) lines in
  let rec up found = function
    | first :: _ when starts first -> Some (first :: found)
    | line :: rest -> up (line :: found) rest
    | [] -> None
  in
  let rec down = function
    | line :: rest when line = "" || line.[0] = ' ' -> line :: down rest
    | _ -> []
  in
  Option.map
    (fun above ->
      let words = List.concat_map (String.split_on_char ' ') (above @ down after) in
      let first = List.hd above in
      (String.sub first 0 (forward Character.is_name first 0), List.mem "where" words))
    (up [] (List.rev before))

let signature ~text (span : Span.t) =
  Option.bind (definition ~text span) (fun (name, _) ->
      List.find_opt (String.starts_with ~prefix:(name ^ " :: ")) (String.split_on_char '\n' text))

let unit_of_literal ~text (span : Span.t) =
  let line = line_of text span in
  let is_inside c = c <> '[' && c <> ']' && c <> '\000' in
  let first = Span.column span.start - 1 and last = Span.column span.stop - 1 in
  let opening = backward is_inside line first and closing = forward is_inside line last in
  let start = backward is_of_a_number line (opening - 1) in
  if char_at line (opening - 1) = '[' && char_at line closing = ']' && start < opening - 1 then
    Some
      ( String.sub line start (opening - 1 - start),
        String.sub line opening (first - opening),
        String.sub line last (closing - last) )
  else None

let assigned ~text (span : Span.t) =
  let line = line_of text span in
  match Basis.Own_equation.of_line line with
  | Some (name, right, start) -> Some (name, right, on_line span start (start + String.length right))
  | None -> None

let divided_difference ~text (span : Span.t) =
  let line = line_of text span in
  let slash = backward (Char.equal ' ') line (Span.column span.start - 1) - 1 in
  let closing = backward (Char.equal ' ') line slash - 1 in
  let rec opening i depth =
    match char_at line i with
    | '\000' -> None
    | ')' -> opening (i - 1) (depth + 1)
    | '(' -> if depth = 1 then Some i else opening (i - 1) (depth - 1)
    | _ -> opening (i - 1) depth
  in
  if char_at line slash <> '/' || char_at line closing <> ')' then None
  else
    Option.bind (opening closing 0) (fun first ->
        let inside = String.sub line (first + 1) (closing - first - 1) in
        match String.split_on_char '-' inside with
        | [ x; _ ] when String.trim x <> "" ->
            Some (on_line span first (Span.column span.stop - 1), Source.grouped (String.trim x))
        | _ -> None)

let product ~text (span : Span.t) =
  let line = line_of text span in
  let start = Span.column span.start - 1 and stop = Span.column span.stop - 1 in
  let is_blank = Char.equal ' ' in
  let name from until = String.sub line from (until - from) in
  let other_operator i = String.contains "*/^.!'" (char_at line i) in
  let around from until =
    (* the product must not be part of a longer product *)
    let before = backward is_blank line from - 1 and after = forward is_blank line until in
    (before < 0 || not (other_operator before)) && not (other_operator after)
  in
  let before = backward is_blank line start - 1 and after = forward is_blank line stop in
  if before > 0 && line.[before] = '*' then
    let until = backward is_blank line before in
    let from = backward is_of_a_name line until in
    if from < until && around from stop then
      Some (on_line span from stop, name from until, name start stop)
    else None
  else if char_at line after = '*' then
    let from = forward is_blank line (after + 1) in
    let until = forward is_of_a_name line from in
    if from < until && around start until then
      Some (on_line span start until, name start stop, name from until)
    else None
  else None

let record ~text (span : Span.t) =
  let line = line_of text span in
  let start = forward (Char.equal ' ') line (Span.column span.stop - 1) in
  match (char_at line start, String.index_from_opt line (min start (String.length line)) '}') with
  | '{', Some stop -> (
      let field text =
        match String.split_on_char '=' text with
        | [ name; value ] -> Some (String.trim name, String.trim value)
        | _ -> None
      in
      let inside = String.sub line (start + 1) (stop - start - 1) in
      let fields = List.map field (String.split_on_char ',' inside) in
      match String.contains inside '{' || List.mem None fields with
      | true -> None
      | false ->
          Some (on_line span (Span.column span.start - 1) (stop + 1), List.filter_map Fun.id fields)
      )
  | _ -> None

(* The index after the closing bracket that matches the bracket at this index. *)
let closing line i =
  let rec close i depth =
    match char_at line i with
    | '\000' -> None
    | '(' | '[' -> close (i + 1) (depth + 1)
    | ')' | ']' -> if depth = 1 then Some (i + 1) else close (i + 1) (depth - 1)
    | _ -> close (i + 1) depth
  in
  close i 0

let in_parentheses ~text (span : Span.t) =
  let line = line_of text span and start = Span.column span.stop - 1 in
  if char_at line start <> '(' then None
  else
    Option.map
      (fun stop ->
        ( on_line span (Span.column span.start - 1) stop,
          String.sub line (start + 1) (stop - start - 2) ))
      (closing line start)

let application ~text (span : Span.t) =
  let line = line_of text span in
  let argument i =
    match char_at line i with
    | '(' -> closing line i
    | c when Character.is_digit c ->
        let stop = forward is_of_a_number line i in
        if char_at line stop = '[' then closing line stop else Some stop
    | c when Character.is_name c -> Some (forward is_of_a_name line i)
    | _ -> None
  in
  let rec arguments found last =
    let start = forward (Char.equal ' ') line last in
    match if start = last then None else argument start with
    | Some stop -> arguments (String.sub line start (stop - start) :: found) stop
    | None -> (List.rev found, last)
  in
  match arguments [] (Span.column span.stop - 1) with
  | [], _ -> None
  | found, last -> Some (on_line span (Span.column span.start - 1) last, found)

let arguments ~text (span : Span.t) =
  let line = line_of text span in
  let first = Span.column span.start - 1 and opening = Span.column span.stop - 1 in
  let rec close i depth =
    match char_at line i with
    | '\000' -> None
    | '(' -> close (i + 1) (depth + 1)
    | ')' -> if depth = 1 then Some i else close (i + 1) (depth - 1)
    | _ -> close (i + 1) depth
  in
  if char_at line opening <> '(' then application ~text span
  else
    Option.bind (close opening 0) (fun closing ->
        String.sub line (opening + 1) (closing - opening - 1)
        |> Other_notation.arguments
        |> Option.map (fun all -> (on_line span first (closing + 1), all)))
