(* An underline within one line. [from] and [upto] are initially byte offsets, and later terminal
   columns. *)
type mark = { main : bool; from : int; upto : int; text : string }

let widest_line = 120

type paint = { colour : bool; severity : Diagnostic.severity }

let painted paint code text =
  if paint.colour && text <> "" then Printf.sprintf "\027[%sm%s\027[0m" code text else text

let severity_code paint =
  match paint.severity with Diagnostic.Error -> "1;31" | Diagnostic.Warning -> "1;33"

let strong paint text = painted paint "1" text
let frame paint text = painted paint "1;34" text
let main_colour paint text = painted paint (severity_code paint) text
let mark_colour paint main text = if main then main_colour paint text else frame paint text

(* {1 Selecting lines} *)

(* The lines of one place, with the byte range to mark in each line. If a place spans several lines,
   only the first and the last are marked. *)
let lines_of source ~main ((at : Span.t), text) =
  let line n = Option.value ~default:"" (Source.line source at.file n) in
  let mark n first stop text = (n, { main; from = first - 1; upto = stop - 1; text }) in
  let first_letter n =
    let s = line n in
    let rec go i = if i < String.length s && (s.[i] = ' ' || s.[i] = '\t') then go (i + 1) else i in
    1 + go 0
  in
  if Span.line at.stop <= Span.line at.start then
    [ mark (Span.line at.start) (Span.column at.start) (Span.column at.stop) text ]
  else
    let last, stop =
      (* an end at the start of a line belongs to the previous line *)
      if Span.column at.stop = 1 then
        (Span.line at.stop - 1, String.length (line (Span.line at.stop - 1)) + 1)
      else (Span.line at.stop, Span.column at.stop)
    in
    if last <= Span.line at.start then
      [
        mark (Span.line at.start) (Span.column at.start)
          (String.length (line (Span.line at.start)) + 1)
          text;
      ]
    else
      [
        mark (Span.line at.start) (Span.column at.start)
          (String.length (line (Span.line at.start)) + 1)
          "";
        mark last (first_letter last) stop text;
      ]

(* {1 A line with its marks} *)

(* Writes [text] into a row of cells, starting at [column]. A cell consists of a displayed character
   and a flag that is set if it belongs to the main mark. *)
let put row column main text = String.iteri (fun i c -> row.(column + i) <- (c, main)) text

let row_text paint row =
  let last = ref (Array.length row) in
  while !last > 0 && fst row.(!last - 1) = ' ' do
    decr last
  done;
  let text = Buffer.create 80 in
  let rec go i =
    if i < !last then (
      let c, main = row.(i) in
      let rec same k = if k < !last && row.(k) = (c, main) then same (k + 1) else k in
      let stop = same i in
      let piece = String.make (stop - i) c in
      Buffer.add_string text (if c = ' ' then piece else mark_colour paint main piece);
      go stop)
  in
  go 0;
  Buffer.contents text

let underline paint marks ~width =
  let row = Array.make width (' ', false) in
  let draw main =
    List.iter
      (fun m ->
        if m.main = main then
          put row m.from main (String.make (m.upto - m.from) (if main then '^' else '-')))
      marks
  in
  draw false;
  draw true;
  row_text paint row

(* The rightmost text is on the row of the underlines. The others follow on separate rows, from
   right to left, with vertical bars below the marks whose texts are on later rows. *)
let rows paint marks ~width =
  let underlined = underline paint marks ~width in
  let texts =
    List.filter (fun m -> m.text <> "") marks
    |> List.stable_sort (fun a b -> compare (b.from, a.main) (a.from, b.main))
  in
  let last_column = List.fold_left (fun last m -> max last m.upto) 0 marks in
  match texts with
  | [] -> [ underlined ]
  | right :: others ->
      let beside, hanging =
        if right.upto = last_column then
          ([ underlined ^ " " ^ mark_colour paint right.main right.text ], others)
        else ([ underlined ], texts)
      in
      let bars marks =
        let row = Array.make width (' ', false) in
        List.iter (fun m -> put row m.from m.main "|") (List.rev marks);
        row_text paint row
      in
      let rec hang = function
        | [] -> []
        | m :: rest ->
            let left = List.filter (fun other -> other.from < m.from) rest in
            let row = Array.make (m.from + 1) (' ', false) in
            List.iter (fun other -> put row other.from other.main "|") left;
            let before = row_text paint row in
            let shown =
              let used = match left with [] -> 0 | first :: _ -> first.from + 1 in
              before ^ String.make (max 0 (m.from - used)) ' ' ^ mark_colour paint m.main m.text
            in
            shown :: hang rest
      in
      beside @ (if hanging = [] then [] else [ bars hanging ]) @ hang hanging

let in_columns display mark =
  let from = Display.column display mark.from in
  { mark with from; upto = max (from + 1) (Display.column display mark.upto) }

(* Only this many bytes of a very long line are examined. *)
let longest_line = 4000

let cut line marks =
  let length = String.length line in
  if length <= longest_line then (line, marks)
  else
    let first = List.fold_left (fun least m -> min least m.from) length marks in
    let rec boundary i =
      if i > 0 && i < length && Utf8.is_continuation line.[i] then boundary (i - 1) else i
    in
    let start = boundary (max 0 (min first length - (longest_line / 2))) in
    let stop = boundary (min length (start + longest_line)) in
    let shift column = max 0 (min (stop - start) (column - start)) in
    ( String.sub line start (stop - start),
      List.map (fun m -> { m with from = shift m.from; upto = shift m.upto }) marks )

(* The part of a long line around its first mark. *)
let window display marks =
  let from =
    if Display.width display <= widest_line then 0
    else
      let first = List.fold_left (fun least m -> min least m.from) max_int marks in
      max 0 (first - (widest_line / 3))
  in
  let clip column = max 0 (min widest_line (column - from)) in
  let inside m =
    let first = min (clip m.from) (widest_line - 1) in
    { m with from = first; upto = max (first + 1) (clip m.upto) }
  in
  let text = Display.part display ~from ~width:widest_line in
  let before = if from > 0 then "…" else "" in
  let after = if Display.width display > from + widest_line then "…" else "" in
  let shift m = if from > 0 then { m with from = m.from + 1; upto = m.upto + 1 } else m in
  (before ^ text ^ after, List.map (fun m -> shift (inside m)) marks)

(* {1 Excerpts} *)

let excerpt paint source file places ~gutter =
  let margin = String.make gutter ' ' in
  let bar = frame paint (margin ^ " |") in
  let marked =
    List.concat_map (fun (main, place) -> lines_of source ~main place) places
    |> List.stable_sort (fun (a, _) (b, _) -> compare a b)
  in
  let rec group = function
    | [] -> []
    | (n, m) :: rest -> (
        match group rest with
        | (k, marks) :: groups when k = n -> (n, m :: marks) :: groups
        | groups -> (n, [ m ]) :: groups)
  in
  let show n marks =
    let line, marks = cut (Option.value ~default:"" (Source.line source file n)) marks in
    let display = Display.of_line line in
    let text, marks = window display (List.map (in_columns display) marks) in
    let number = frame paint (Printf.sprintf "%*d |" gutter n) in
    let code = if text = "" then number else number ^ " " ^ text in
    let width = 2 + List.fold_left (fun w m -> max w m.upto) 0 marks in
    let under = if marks = [] then [] else rows paint marks ~width in
    code :: List.map (fun row -> bar ^ " " ^ row) under
  in
  let rec lines before = function
    | [] -> []
    | (n, marks) :: rest ->
        let gap =
          match before with
          | Some k when n = k + 2 -> show (k + 1) []
          | Some k when n > k + 2 -> [ frame paint "..." ]
          | Some _ | None -> []
        in
        gap @ show n marks @ lines (Some n) rest
  in
  (bar :: lines None (group marked)) @ [ bar ]

(* {1 A diagnostic} *)

let place source (at : Span.t) =
  let column =
    match Source.line source at.file (Span.line at.start) with
    | Some line -> 1 + Display.characters_before line (Span.column at.start - 1)
    | None -> Span.column at.start
  in
  Printf.sprintf "%s:%d:%d" (Printable.name at.file) (Span.line at.start) column

(* Escapes control characters, because diagnostics may quote untrusted text. *)
let shown text = Printable.text (Diagnostic.for_display text)

let header paint (d : Diagnostic.t) =
  let kind = match d.severity with Error -> "error" | Warning -> "warning" in
  main_colour paint (Printf.sprintf "%s[%s]" kind d.code) ^ strong paint (": " ^ shown d.message)

let diagnostic ~colour source (d : Diagnostic.t) =
  let paint = { colour; severity = d.severity } in
  let places =
    (true, (d.at, Option.fold d.here ~none:"" ~some:shown))
    :: List.map (fun (l : Diagnostic.label) -> (false, (l.at, shown l.text))) d.labels
  in
  let file_of (_, ((at : Span.t), _)) = at.file in
  let rec files seen = function
    | [] -> List.rev seen
    | p :: rest -> files (if List.mem (file_of p) seen then seen else file_of p :: seen) rest
  in
  let last_line (_, ((at : Span.t), _)) = max (Span.line at.start) (Span.line at.stop) in
  let gutter =
    String.length (string_of_int (List.fold_left (fun n p -> max n (last_line p)) 1 places))
  in
  let margin = String.make gutter ' ' in
  let section file =
    let here = List.filter (fun p -> String.equal (file_of p) file) places in
    let is_main = String.equal file d.at.file in
    let first = match here with (_, (at, _)) :: _ -> at | [] -> d.at in
    let arrow = frame paint (margin ^ if is_main then "-->" else ":::") in
    let heading = Printf.sprintf "%s %s" arrow (place source first) in
    match Source.text source file with
    | Some _ -> heading :: excerpt paint source file here ~gutter
    | None ->
        let told =
          List.filter_map
            (fun (_, (_, text)) ->
              if text = "" then None else Some (frame paint (margin ^ " |") ^ " " ^ text))
            here
        in
        heading :: told
  in
  let sections = List.concat_map section (files [] places) in
  let foot kind text =
    let lines = String.split_on_char '\n' (shown text) in
    let lead = Printf.sprintf "%s = " margin in
    let indent = String.make (String.length lead + String.length kind + 2) ' ' in
    match lines with
    | [] -> []
    | first :: rest ->
        (frame paint (margin ^ " =") ^ " " ^ strong paint (kind ^ ":") ^ " " ^ first)
        :: List.map (fun line -> indent ^ line) rest
  in
  let notes = List.concat_map (foot "note") d.notes in
  let hints = List.concat_map (fun (h : Diagnostic.hint) -> foot "hint" h.text) d.hints in
  (* drop the last bar if nothing follows it *)
  let sections =
    match List.rev sections with
    | last :: before when notes = [] && hints = [] && last = frame paint (margin ^ " |") ->
        List.rev before
    | _ -> sections
  in
  String.concat "\n" ((header paint d :: sections) @ notes @ hints) ^ "\n"

let most_shown = 100
let with_severity severity = List.filter (fun (d : Diagnostic.t) -> d.severity = severity)

let first_of_each ~most list =
  let errors = ref 0 and warnings = ref 0 in
  let is_among_first (d : Diagnostic.t) =
    let count = match d.severity with Error -> errors | Warning -> warnings in
    incr count;
    !count <= most
  in
  List.filter is_among_first list

let summary list =
  let errors = List.length (with_severity Error list) in
  let warnings = List.length (with_severity Warning list) in
  let say n what =
    if n = 0 then [] else [ Printf.sprintf "%d %s%s" n what (if n = 1 then "" else "s") ]
  in
  let of_each what = Printf.sprintf "; the first %d%s are shown" most_shown what in
  let cut =
    match (errors > most_shown, warnings > most_shown) with
    | true, true -> of_each " of each"
    | true, false -> of_each (if warnings = 0 then "" else " errors")
    | false, true -> of_each (if errors = 0 then "" else " warnings")
    | false, false -> ""
  in
  match say errors "error" @ say warnings "warning" with
  | [] -> ""
  | parts -> String.concat ", " parts ^ cut ^ "\n"

let diagnostics ~colour source list =
  let errors, warnings = List.partition (fun (d : Diagnostic.t) -> d.severity = Error) list in
  let text = Buffer.create 1024 in
  List.iter
    (fun d ->
      Buffer.add_string text (diagnostic ~colour source d);
      Buffer.add_char text '\n')
    (first_of_each ~most:most_shown (errors @ warnings));
  Buffer.add_string text (summary list);
  Buffer.contents text
