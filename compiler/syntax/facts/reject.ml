exception Rejected of Rejection.t
exception Command of { command : Basis.Span.t; block : Lexing.position }

let because reason = raise (Rejected reason)
