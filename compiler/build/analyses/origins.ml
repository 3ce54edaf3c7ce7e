open Basis
open Probe.Origin

let line = Span.line

(* The end of a span is exclusive: if it is the first column of a line, the span's last line is the
   line before. *)
let last_line (place : Span.t) =
  let start = Span.position ~line:(line place.stop) ~column:1 in
  max (line place.start) (if place.stop = start then line place.stop - 1 else line place.stop)

let back = function Instants n -> string_of_int n | First -> "FROB_FIRST" | Entry -> "FROB_ENTRY"

(* Writes a table of these rows and returns its name; [NULL] if there are no rows. *)
let table out ~kind ~name ~last rows =
  if rows = [] then "NULL"
  else (
    Printf.bprintf out "static const struct frob_%s %s[] = {\n" kind name;
    List.iter (Printf.bprintf out "    {%s},\n") rows;
    Printf.bprintf out "    {%s},\n};\n" last;
    name)

let quoted = Basis.C_string.literal

let sources out name (all : source list) =
  let row (s : source) =
    let machine, mode = Option.value s.where_ ~default:("", any) in
    Printf.sprintf "%s, %s, %s, %d" (quoted s.column) (back s.back) (quoted machine) mode
  in
  table out ~kind:"source" ~name ~last:"NULL, 0, NULL, 0" (List.map row all)

let place (p : Span.t) =
  Printf.sprintf "%s, %d, %d" (quoted (Filename.basename p.file)) (line p.start) (last_line p)

let transition out name k (e : transition) =
  let sources = sources out (Printf.sprintf "%s_%d" name k) e.sources in
  Printf.sprintf "%d, %d, %s, %d, %d, %s, %s" e.from e.target (quoted e.label)
    (Bool.to_int e.delayed) (Bool.to_int e.at_once) (place e.place) sources

let origin out k (o : t) =
  let name kind = Printf.sprintf "%s_%d" kind k in
  let sources = sources out (name "sources") o.sources in
  let transitions =
    table out ~kind:"transition" ~name:(name "transitions")
      ~last:"0, 0, NULL, 0, 0, NULL, 0, 0, NULL"
      (List.mapi (transition out (name "events")) o.transitions)
  in
  Printf.sprintf "    {%s, %s, %s, %s},\n" (quoted o.column) (place o.place) sources transitions

let text all =
  let out = Buffer.create 16384 in
  Buffer.add_string out "#include <frob/origins.h>\n#include <stddef.h>\n\n";
  let rows = List.mapi (origin out) all in
  Printf.bprintf out "const struct frob_origin frob_origins[] = {\n%s%s};\n" (String.concat "" rows)
    "    {NULL, NULL, 0, 0, NULL, NULL},\n";
  Buffer.contents out
