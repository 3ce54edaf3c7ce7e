open Basis

exception Rejected of Diagnostic.t
exception Command of { command : Span.t; block : Lexing.position }
exception With_text of ((Span.t -> string option) -> Diagnostic.t)

let diagnostic d = raise (Rejected d)
let with_text explain = raise (With_text explain)

let at ~code span ?hint format =
  Printf.ksprintf
    (fun message ->
      let d = Diagnostic.error ~code ~at:span "%s" message in
      diagnostic (match hint with None -> d | Some hint -> Diagnostic.hint hint d))
    format
