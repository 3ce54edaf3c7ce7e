type kind = Integral | Previous

type t = {
  kind : kind;
  before : (string * string) option;
  right : string;
  edits : (Span.t * string) list;
}

(* Does the next line of code continue a definition that starts at this column? *)
let rec is_continued sources (at : Span.t) line =
  match Source.line sources at.file line with
  | None -> false
  | Some text -> (
      match String.trim text with
      | "" -> is_continued sources at (line + 1)
      | trimmed -> String.index text trimmed.[0] + 1 > Span.column at.start)

(* The text up to the end of the expression: the first closing bracket, comma, semicolon or
   comment. *)
let expression text =
  let n = String.length text in
  let is_comment i = i + 1 < n && text.[i] = '-' && text.[i + 1] = '-' in
  let rec stop i depth =
    if i >= n || is_comment i then i
    else
      match text.[i] with
      | '(' | '[' -> stop (i + 1) (depth + 1)
      | (')' | ']' | ',' | ';') when depth = 0 -> i
      | ')' | ']' -> stop (i + 1) (depth - 1)
      | _ -> stop (i + 1) depth
  in
  String.trim (String.sub text 0 (stop 0 0))

let of_line text =
  match String.index_opt text '=' with
  | None -> None
  | Some i ->
      let name = String.trim (String.sub text 0 i) in
      let right = String.sub text (i + 1) (String.length text - i - 1) in
      let written = expression right in
      if name = "" || (not (String.for_all Character.is_name name)) || written = "" then None
      else Some (name, written, i + 1 + String.index right written.[0])

(* The right-hand side of the equation [name = …] at this place, and its span. [None] if the
   equation is not on one line. *)
let right_side sources ~name ~(at : Span.t) =
  let line = Span.line at.start in
  match Source.line sources at.file line with
  | Some text when not (is_continued sources at (line + 1)) -> (
      let first = Span.column at.start - 1 in
      match of_line (String.sub text first (String.length text - first)) with
      | Some (left, written, column) when String.equal left name ->
          let column = first + column + 1 in
          let start = Span.position ~line ~column in
          let stop = Span.position ~line ~column:(column + String.length written) in
          Some (written, Span.make ~file:at.file ~start ~stop)
      | Some _ | None -> None)
  | Some _ | None -> None

(* The terms of a sum or difference, each with its sign. Ignores operators inside brackets. *)
let terms text =
  let n = String.length text in
  let add sign from until found =
    (sign, String.trim (String.sub text from (until - from))) :: found
  in
  let rec go i from sign depth found =
    if i >= n then List.rev (add sign from n found)
    else
      match text.[i] with
      | '(' | '[' -> go (i + 1) from sign (depth + 1) found
      | ')' | ']' -> go (i + 1) from sign (depth - 1) found
      | ('+' | '-') as c
        when depth = 0 && i > 0 && i + 1 < n && text.[i - 1] = ' ' && text.[i + 1] = ' ' ->
          go (i + 1) (i + 1) c depth (add sign from i found)
      | _ -> go (i + 1) from sign depth found
  in
  go 0 0 '+' 0 []

(* Is the text a time step, such as `0.02[s]` or `dt`? *)
let is_a_step text =
  let is_number text = float_of_string_opt text <> None in
  let of_unit unit_ =
    let suffix = Printf.sprintf "[%s]" unit_ in
    String.ends_with ~suffix text
    && is_number (String.sub text 0 (String.length text - String.length suffix))
  in
  String.equal text "dt" || List.exists of_unit [ "s"; "ms" ]

(* The rate in `rate * 0.02[s]` or `0.02[s] * rate`. *)
let rate product =
  match String.rindex_opt product '*' with
  | None -> None
  | Some i ->
      let part from until = String.trim (String.sub product from (until - from)) in
      let last = part (i + 1) (String.length product) in
      let first = String.index product '*' in
      if is_a_step last then Some (part 0 i)
      else if is_a_step (part 0 first) then Some (part (first + 1) (String.length product))
      else None

let integral ~name text =
  let of_rate sign product =
    Option.map
      (fun rate -> (if sign = '-' then "-" else "") ^ "integral " ^ Source.grouped rate)
      (rate product)
  in
  match terms text with
  | [ ('+', x); (sign, product) ] when String.equal x name -> of_rate sign product
  | [ ('+', product); ('+', x) ] when String.equal x name -> of_rate '+' product
  | _ -> None

(* Replaces the name [read] by the text [by], in parentheses where it is an argument or a
   function. *)
let replaced ~read ~by text =
  let n = String.length text in
  let is_part c = Character.is_name c || c = '.' in
  let rec stop i = if i < n && is_part text.[i] then stop (i + 1) else i in
  let rec before i = if i >= 0 && text.[i] = ' ' then before (i - 1) else i in
  let rec after i = if i < n && text.[i] = ' ' then after (i + 1) else i in
  let ends_a_term i = i >= 0 && (Character.is_name text.[i] || text.[i] = ')' || text.[i] = ']') in
  let keywords = [ "if"; "then"; "else"; "of"; "in" ] in
  let word_before i =
    let rec start j = if j > 0 && Character.is_name text.[j - 1] then start (j - 1) else j in
    if i < 0 then ""
    else
      let j = start (i + 1) in
      String.sub text j (i + 1 - j)
  in
  let begins_a_term i =
    i < n
    && (Character.is_name text.[i] || text.[i] = '(')
    && not (List.mem (String.sub text i (stop i - i)) keywords)
  in
  let rec go i from count parts =
    if i >= n then (count, String.concat "" (List.rev (String.sub text from (n - from) :: parts)))
    else
      let last = stop i in
      if last = i then go (i + 1) from count parts
      else if String.equal (String.sub text i (last - i)) read then
        let previous = before (i - 1) in
        let is_argument =
          previous < i - 1 && ends_a_term previous && not (List.mem (word_before previous) keywords)
        in
        let is_function = last < n && text.[last] = ' ' && begins_a_term (after last) in
        let by = if is_argument || is_function then "(" ^ by ^ ")" else by in
        go last last (count + 1) (by :: String.sub text from (i - from) :: parts)
      else go last from count parts
  in
  match go 0 0 0 [] with 0, _ -> None | _, text -> Some text

let words text =
  String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') text)

(* Does the text contain a branch or a function? These cannot run a signal function. *)
let has_a_branch text =
  List.exists (fun word -> List.mem word [ "if"; "case"; "let" ]) (words text)
  || String.contains text '\\'

(* Inserts an equation for the previous value before the equation at this place. *)
let with_equation ~at:(place : Span.t) ~right ~read ~start text =
  let name =
    if List.mem "before" (words text) || String.equal read "before" then "earlier" else "before"
  in
  Option.map
    (fun written ->
      let delayed = Printf.sprintf "delay %s %s" start read in
      let line =
        Printf.sprintf "%s = %s\n%s" name delayed (String.make (Span.column place.start - 1) ' ')
      in
      {
        kind = Previous;
        before = Some (name, delayed);
        right = written;
        edits = [ ({ place with stop = place.start }, line); (right, written) ];
      })
    (replaced ~read ~by:name text)

let fix sources ~name ~at ~read ~start =
  Option.bind (right_side sources ~name ~at) (fun (text, place) ->
      let with_right kind right = { kind; before = None; right; edits = [ (place, right) ] } in
      match if String.equal name read then integral ~name text else None with
      | Some right -> Some (with_right Integral right)
      | None when has_a_branch text -> with_equation ~at ~right:place ~read ~start text
      | None ->
          let by = Printf.sprintf "delay %s %s" start read in
          Option.map (with_right Previous) (replaced ~read ~by text))
