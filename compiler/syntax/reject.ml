open Basis

exception Rejected of Diagnostic.t
exception Command of { command : Span.t; block : Lexing.position }

let diagnostic d = raise (Rejected d)

let at ~code span ?hint format =
  Printf.ksprintf
    (fun message ->
      let d = Diagnostic.error ~code ~at:span "%s" message in
      diagnostic (match hint with None -> d | Some hint -> Diagnostic.hint hint d))
    format
