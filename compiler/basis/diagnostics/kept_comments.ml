let starts_at text k word =
  let n = String.length word in
  k + n <= String.length text && String.equal (String.sub text k n) word

(* The offset just after the comment that begins at [k]. *)
let stop text k =
  let n = String.length text in
  if starts_at text k "--" then Option.value (String.index_from_opt text k '\n') ~default:n
  else
    let rec nested depth k =
      if depth = 0 || k >= n then min k n
      else if starts_at text k "{-" then nested (depth + 1) (k + 2)
      else if starts_at text k "-}" then nested (depth - 1) (k + 2)
      else nested depth (k + 1)
    in
    nested 1 (k + 2)

let rec behind_string text k =
  if k >= String.length text || text.[k] = '\n' then k
  else if text.[k] = '"' then k + 1
  else behind_string text (if text.[k] = '\\' then k + 2 else k + 1)

let without_end line =
  let n = String.length line in
  if n > 0 && line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line

(* The offset of the first comment at or after [k], or of the end of the text. *)
let rec next text k =
  if k >= String.length text || starts_at text k "--" || starts_at text k "{-" then
    min k (String.length text)
  else next text (if text.[k] = '"' then behind_string text (k + 1) else k + 1)

let in_text text =
  let rec from k found =
    let start = next text k in
    if start >= String.length text then List.rev found
    else
      let stop = stop text start in
      from stop (without_end (String.sub text start (stop - start)) :: found)
  in
  from 0 []

let code text = String.trim (String.sub text 0 (next text 0))
let is_line_comment = String.starts_with ~prefix:"--"
let documents comment = String.starts_with ~prefix:"-- |" comment

let contains text part =
  let n = String.length part in
  let rec from k = k + n <= String.length text && (String.sub text k n = part || from (k + 1)) in
  from 0

(* Code after a line comment continues on the next line, indented to [column], because code in the
   first column would begin a new declaration. *)
let written ~whole_lines ~column text comments =
  let margin = String.make column ' ' in
  let one comment =
    if whole_lines then comment ^ "\n"
    else if is_line_comment comment then Printf.sprintf " %s\n%s" comment margin
    else Printf.sprintf " %s " comment
  in
  text ^ String.concat "" (List.map one comments)

let indentation line =
  let n = String.length line in
  let rec from k = if k < n && (line.[k] = ' ' || line.[k] = '\t') then from (k + 1) else k in
  from 0

let fix sources (fix : Diagnostic.fix) =
  let edit (e : Diagnostic.edit) =
    let whole = Option.value (Source.text sources e.span.file) ~default:"" in
    let start = Source.offset sources e.span.file e.span.start in
    let stop = Source.offset sources e.span.file e.span.stop in
    let removed = String.sub whole start (max 0 (stop - start)) in
    let is_lost comment =
      not (List.exists (fun (other : Diagnostic.edit) -> contains other.text comment) fix.edits)
    in
    match List.filter is_lost (in_text removed) with
    | [] -> (e, [])
    | lost ->
        let begins k = k = 0 || whole.[k - 1] = '\n' in
        let whole_lines = e.text = "" && begins start && begins stop in
        let line = Source.line sources e.span.file (Span.line e.span.stop) in
        let line = Option.value line ~default:"" in
        let column = max 4 (indentation line) in
        ({ e with text = written ~whole_lines ~column e.text lost }, lost)
  in
  let edits = List.map edit fix.edits in
  if List.exists documents (List.concat_map snd edits) then None
  else Some { fix with edits = List.map fst edits }
