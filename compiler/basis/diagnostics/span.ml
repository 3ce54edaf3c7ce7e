(* Line and column packed into one integer, so that comparing and copying a position is cheap. *)
type position = int
type t = { file : string; start : position; stop : position }

let bits_of_column = 28
let last_column = (1 lsl bits_of_column) - 1
let position ~line ~column = (line lsl bits_of_column) lor Int.min column last_column
let line position = position lsr bits_of_column
let column position = position land last_column
let forward n p = position ~line:(line p) ~column:(column p + n)
let make ~file ~start ~stop = { file; start; stop }

let merge a b =
  if String.equal a.file b.file then
    { a with start = Int.min a.start b.start; stop = Int.max a.stop b.stop }
  else a

let compare a b =
  match String.compare a.file b.file with
  | 0 -> ( match Int.compare a.start b.start with 0 -> Int.compare a.stop b.stop | order -> order)
  | order -> order

let start_of_file file =
  let start = position ~line:1 ~column:1 in
  { file; start; stop = start }

let pp ppf t = Format.fprintf ppf "%s:%d:%d" t.file (line t.start) (column t.start)
