open Basis

type constant = { name : string; unit_ : string; place : Span.t }
type t = at:Span.t -> float -> constant option

let none ~at:_ _ = None

let definition ~program real { unit_; place; name = _ } ~name x =
  let file = Filename.basename place.file and line = Span.line place.start in
  let place =
    if String.equal file (program ^ ".frob") then Printf.sprintf "line %d" line
    else Printf.sprintf "%s:%d" (C_string.comment file) line
  in
  let comment = if String.equal unit_ "" then place else unit_ ^ ", " ^ place in
  Printf.sprintf "static const %s %s = %s; /* %s */\n" (Print.real_name real) name
    (Print.float_literal real x) comment
