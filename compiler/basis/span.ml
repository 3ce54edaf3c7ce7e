type position = { line : int; column : int }
type t = { file : string; start : position; stop : position }

let make ~file ~start ~stop = { file; start; stop }

let is_before a b = a.line < b.line || (a.line = b.line && a.column < b.column)
let earlier a b = if is_before b a then b else a
let later a b = if is_before a b then b else a

let merge a b =
  if String.equal a.file b.file then
    { a with start = earlier a.start b.start; stop = later a.stop b.stop }
  else a

let compare = compare

let start_of_file file =
  let start = { line = 1; column = 1 } in
  { file; start; stop = start }

let pp ppf t = Format.fprintf ppf "%s:%d:%d" t.file t.start.line t.start.column
