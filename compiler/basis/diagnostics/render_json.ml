open Json

let character source (p : Span.position) file =
  match Source.line source file (Span.line p) with
  | Some line -> 1 + Display.characters_before line (Span.column p - 1)
  | None -> Span.column p

let place source (at : Span.t) =
  [
    ("file_name", String at.file);
    ("byte_start", Int (Source.offset source at.file at.start));
    ("byte_end", Int (Source.offset source at.file at.stop));
    ("line_start", Int (Span.line at.start));
    ("line_end", Int (Span.line at.stop));
    ("column_start", Int (character source at.start at.file));
    ("column_end", Int (character source at.stop at.file));
  ]

(* Limits on the excerpts. More lines of a long span would not help the reader, and a very long line
   is not readable. *)
let most_lines = 10
let longest_line = 2000

let span source ~primary ~label (at : Span.t) =
  let column_start = character source at.start at.file in
  let column_end = character source at.stop at.file in
  let last = min (Span.line at.stop) (Span.line at.start + most_lines - 1) in
  let lines = List.init (max 1 (last - Span.line at.start + 1)) (fun i -> Span.line at.start + i) in
  let line n =
    match Source.line source at.file n with
    | None -> None
    | Some text when String.length text > longest_line -> None
    | Some text ->
        let whole = 1 + Display.characters_before text (String.length text) in
        Some
          (Object
             [
               ("text", String text);
               ("highlight_start", Int (if n = Span.line at.start then column_start else 1));
               ("highlight_end", Int (if n = Span.line at.stop then column_end else whole));
             ])
  in
  Object
    (place source at
    @ [
        ("is_primary", Bool primary);
        ("text", List (List.filter_map line lines));
        ("label", if label = "" then Null else String label);
      ])

let for_display = Diagnostic.for_display

let fix source (f : Diagnostic.fix) =
  let edit (e : Diagnostic.edit) =
    Object [ ("span", Object (place source e.span)); ("text", String e.text) ]
  in
  Object
    [
      ("title", String (for_display f.title));
      ("safe", Bool f.safe);
      ("edits", List (List.map edit f.edits));
    ]

let child level message =
  Object
    [
      ("message", String (for_display message));
      ("code", Null);
      ("level", String level);
      ("spans", List []);
      ("children", List []);
      ("rendered", Null);
    ]

let diagnostic source (d : Diagnostic.t) =
  let explanation = match Explain.find d.code with Some page -> String page | None -> Null in
  let level = match d.severity with Error -> "error" | Warning -> "warning" in
  Json.to_string
    (Object
       [
         ("message", String (for_display d.message));
         ("code", Object [ ("code", String d.code); ("explanation", explanation) ]);
         ("level", String level);
         ( "spans",
           List
             (span source ~primary:true ~label:(Option.fold d.here ~none:"" ~some:for_display) d.at
             :: List.map
                  (fun (l : Diagnostic.label) ->
                    span source ~primary:false ~label:(for_display l.text) l.at)
                  d.labels) );
         ( "children",
           List
             (List.map (child "note") d.notes
             @ List.map (fun (h : Diagnostic.hint) -> child "help" h.text) d.hints) );
         ("fixes", List (List.map (fix source) d.fixes));
         ("rendered", String (Render_text.diagnostic ~colour:false source d));
       ])

let most_shown = 1_000

(* The contents of an additional object, if some diagnostics are not shown. *)
let rest list =
  let count severity =
    List.length (List.filter (fun (d : Diagnostic.t) -> d.severity = severity) list)
  in
  let errors = max 0 (count Error - most_shown) in
  let warnings = max 0 (count Warning - most_shown) in
  let say n what =
    if n = 0 then [] else [ Printf.sprintf "%d more %s%s" n what (if n = 1 then "" else "s") ]
  in
  match say errors "error" @ say warnings "warning" with
  | [] -> []
  | [ text ] when errors + warnings = 1 -> [ (text ^ " is not shown", errors, warnings) ]
  | texts -> [ (String.concat " and " texts ^ " are not shown", errors, warnings) ]

let cut (message, errors, warnings) =
  Json.to_string
    (Object
       [
         ("message", String message);
         ("code", Null);
         ("level", String "note");
         ("spans", List []);
         ("children", List []);
         ("fixes", List []);
         ("rendered", String ("note: " ^ message ^ "\n"));
         ("left_out", Object [ ("errors", Int errors); ("warnings", Int warnings) ]);
       ])

let diagnostics source list =
  let shown = Render_text.first_of_each ~most:most_shown list in
  let lines = List.map (diagnostic source) shown @ List.map cut (rest list) in
  String.concat "" (List.map (fun line -> line ^ "\n") lines)
