let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'

let ending text at is_part =
  let rec start i = if i > 0 && is_part text.[i - 1] then start (i - 1) else i in
  let first = start at in
  String.sub text first (at - first)

let line_start text at =
  match String.rindex_from_opt text (max 0 (at - 1)) '\n' with
  | Some i when i < at -> i + 1
  | Some _ | None -> 0

let start_of_line text line =
  let rec go start n =
    if n <= 1 then start
    else
      match String.index_from_opt text start '\n' with
      | Some i -> go (i + 1) (n - 1)
      | None -> String.length text
  in
  go 0 line

let offset text position =
  start_of_line text (Basis.Span.line position) + Basis.Span.column position - 1

let end_of_line text at =
  Option.value (String.index_from_opt text at '\n') ~default:(String.length text)

let without_closing text =
  let rec last i depth =
    if i >= String.length text then i
    else
      match text.[i] with
      | '(' -> last (i + 1) (depth + 1)
      | ')' -> if depth = 0 then i else last (i + 1) (depth - 1)
      | _ -> last (i + 1) depth
  in
  String.trim (String.sub text 0 (last 0 0))

let find ?(from = 0) part text =
  let n = String.length part in
  let rec go i =
    if i + n > String.length text then None
    else if String.equal (String.sub text i n) part then Some i
    else go (i + 1)
  in
  go from

let is_a_name word =
  word <> "" && Basis.Character.is_lower word.[0] && String.for_all Basis.Character.is_name word

let replaced ~name ~by text =
  let n = String.length name in
  let is_part c = Basis.Character.is_name c || c = '.' in
  let rec last i = if is_part (char_at text i) then last (i + 1) else i in
  let rec go i from count parts =
    if i >= String.length text then
      let rest = String.sub text from (String.length text - from) in
      (count, String.concat "" (List.rev (rest :: parts)))
    else
      let stop = last i in
      if stop = i then go (i + 1) from count parts
      else if stop - i = n && String.equal (String.sub text i n) name then
        go stop stop (count + 1) (by :: String.sub text from (i - from) :: parts)
      else go stop from count parts
  in
  match go 0 0 0 [] with 0, _ -> None | found -> Some found
