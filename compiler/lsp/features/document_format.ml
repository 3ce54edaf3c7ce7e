open Basis

(* An edit that replaces only the lines from the first to the last change, so that cursors elsewhere
   do not move. *)
let edit ws (doc : Document.t) before after : Json.t =
  let n = String.length before and m = String.length after in
  let shorter = min n m in
  let rec prefix i = if i < shorter && before.[i] = after.[i] then prefix (i + 1) else i in
  let rec line_start i = if i > 0 && before.[i - 1] <> '\n' then line_start (i - 1) else i in
  let start = line_start (prefix 0) in
  let rec suffix i =
    if i < shorter - start && before.[n - 1 - i] = after.[m - 1 - i] then suffix (i + 1) else i
  in
  (* Shortens the common suffix until it starts at the beginning of a line in both texts. *)
  let rec whole i = if i > 0 && before.[n - i - 1] <> '\n' then whole (i - 1) else i in
  let behind =
    let i = suffix 0 in
    if i = 0 then 0 else whole i
  in
  let stop = n - behind in
  Object
    [
      ("range", Workspace.range ws doc.text (start, stop));
      ("newText", String (String.sub after start (m - behind - start)));
    ]

let edits ws (doc : Document.t) =
  let before = Text.contents doc.text in
  match Formatting.Formatter.text (Facts.ignored ()) ~file:doc.path before with
  | Formatted after when String.equal before after -> Ok (Json.List [])
  | Formatted after -> Ok (List [ edit ws doc before after ])
  | Broken -> Ok (List [])
  | Refused law ->
      Error
        (Printf.sprintf "the text was left unchanged, because after formatting %s"
           (Formatting.Laws.name law))
