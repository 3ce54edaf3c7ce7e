open Basis

type t = { contents : string; starts : int array Lazy.t  (** start of each line *) }

let line_starts text =
  let starts = ref [ 0 ] in
  let n = String.length text in
  String.iteri
    (fun i c ->
      if c = '\n' || (c = '\r' && not (i + 1 < n && text.[i + 1] = '\n')) then
        starts := (i + 1) :: !starts)
    text;
  Array.of_list (List.rev !starts)

let of_string contents = { contents; starts = lazy (line_starts contents) }
let contents t = t.contents

type encoding = Utf8 | Utf16 | Utf32
type position = { line : int; character : int }

(* Length of the character that starts at offset [i], in bytes and in units of the encoding. *)
let character encoding text i =
  let length, code = Utf8.decode text i in
  match (length, encoding) with
  | 0, _ -> (1, 1)
  | _, Utf8 -> (length, length)
  | _, Utf16 -> (length, if code > 0xffff then 2 else 1)
  | _, Utf32 -> (length, 1)

(* The last line that starts at or before this offset. *)
let line_at starts offset =
  let rec search low high =
    if low >= high then low
    else
      let middle = (low + high + 1) / 2 in
      if starts.(middle) <= offset then search middle high else search low (middle - 1)
  in
  search 0 (Array.length starts - 1)

let position encoding t offset =
  let starts = Lazy.force t.starts in
  let offset = max 0 (min offset (String.length t.contents)) in
  let line = line_at starts offset in
  let rec count i units =
    if i >= offset then units
    else
      let length, more = character encoding t.contents i in
      if i + length > offset then units else count (i + length) (units + more)
  in
  { line; character = count starts.(line) 0 }

(* End of a line, excluding its line terminator. *)
let end_of_line t starts line =
  let next = if line + 1 < Array.length starts then starts.(line + 1) else -1 in
  if next < 0 then String.length t.contents
  else
    let stop = next - 1 in
    if stop > starts.(line) && t.contents.[stop] = '\n' && t.contents.[stop - 1] = '\r' then
      stop - 1
    else stop

let offset encoding t { line; character = wanted } =
  let starts = Lazy.force t.starts in
  if line < 0 then 0
  else if line >= Array.length starts then String.length t.contents
  else
    let stop = end_of_line t starts line in
    let rec go i units =
      if i >= stop || units >= wanted then i
      else
        let length, more = character encoding t.contents i in
        if units + more > wanted then i else go (i + length) (units + more)
    in
    go starts.(line) 0

let replace t start stop text =
  let n = String.length t.contents in
  let start = max 0 (min start n) in
  let stop = max start (min stop n) in
  of_string
    (String.concat ""
       [ String.sub t.contents 0 start; text; String.sub t.contents stop (n - stop) ])
