(* The parsed header: the index of the time column in the file, and the columns of the input. The
   index of a column refers to a row in which the time has been moved to the front. *)
type header = { width : int; time_cell : int; columns : (Shape.column * place) list }

(* Columns of the console may be missing. *)
and place = Cell of int | At_rest of Value.t

exception Rejected of string list

let complaint name (row : Csv.row) cell format =
  let column = match List.nth_opt row.cells cell with Some { column; _ } -> column | None -> 1 in
  let complaint text =
    Basis.Printable.name (Printf.sprintf "%s:%d:%d: %s" name row.line column text)
  in
  Printf.ksprintf complaint format

(* A hint for a message about a column's name or a time. Whitespace next to a comma is part of the
   text, but hard to see. *)
let on_blanks text =
  let blank i = text.[i] = ' ' || text.[i] = '\t' in
  if text <> "" && (blank 0 || blank (String.length text - 1)) then
    "; remove the spaces next to the commas"
  else ""

let reject texts = raise_notrace (Rejected texts)

let next_row name csv =
  match Csv.next csv with
  | Ok row -> row
  | Error (row, problem) ->
      let cell, text =
        match problem with
        | Unreadable reason -> (0, "cannot read the file: " ^ reason)
        | Unclosed_quote -> (0, "a quoted cell that starts in this row is never closed")
        | Late_quote ->
            ( List.length row.cells - 1,
              "there is a space before a quote; remove the spaces next to the commas" )
        | Zero_byte -> (0, "there is a zero byte: this is not a CSV file")
        | Too_long ->
            ( 0,
              "the row is larger than 16 MB or has more than a million cells: this is not a \
               recording" )
      in
      reject [ complaint name row cell "%s" text ]

(* {1 The header} *)

(* Recordings also contain the output; these columns are ignored. *)
let is_output column =
  let starts prefix =
    String.length column >= String.length prefix
    && String.equal prefix (String.sub column 0 (String.length prefix))
  in
  String.equal column "out" || starts "out." || starts "out[" || starts "mode." || starts "probe."

(* Shortens the list of column names: a robot's input has many, and the message shows the expected
   header anyway. *)
let shortened names =
  let most = 4 in
  if List.length names <= most then String.concat ", " names
  else
    Basis.Enumeration.some
      (List.filteri (fun i _ -> i < most - 1) names)
      ~more:(List.length names - most + 1)

let returns =
  "the lines end with carriage returns only: convert them to line feeds with `tr '\\r' '\\n'`"

let check_line_ends name (row : Csv.row) =
  if List.exists (fun (c : Csv.cell) -> String.contains c.text '\r') row.cells then
    reject [ complaint name row 0 "%s" returns ]

let header name ~dialect columns (row : Csv.row) =
  let time_cell, row =
    let texts = List.map (fun (c : Csv.cell) -> c.text) row.cells in
    match Dialect.header dialect texts with
    | Ok (time_cell, names) ->
        let renamed (cell : Csv.cell) text = { cell with text } in
        let cells = Dialect.to_front time_cell row.cells in
        (time_cell, { row with cells = List.map2 renamed cells names })
    | Error text -> reject [ complaint name row 0 "%s" text ]
  in
  let known = Hashtbl.create 64 and places = Hashtbl.create 64 and unknown = ref [] in
  List.iter (fun (c : Shape.column) -> Hashtbl.replace known c.name ()) columns;
  let complain cell format =
    Printf.ksprintf (fun text -> Some (complaint name row cell "%s" text)) format
  in
  let check i ({ text; _ } : Csv.cell) =
    if i = 0 then
      if String.equal text "time" then None
      else
        let blanks = on_blanks text in
        let texts = List.map (fun (c : Csv.cell) -> c.text) row.cells in
        complain i "the first column must be `time`, but it is `%s`%s" text
          (if blanks <> "" then blanks else Dialect.time_hint dialect texts)
    else if Hashtbl.mem places text then complain i "the column `%s` occurs twice" text
    else if Hashtbl.mem known text then (
      Hashtbl.replace places text i;
      None)
    else if is_output text then None
    else (
      if on_blanks text = "" then unknown := text :: !unknown;
      if Dialect.names dialect then None
      else complain i "the program's input has no `%s`%s" text (on_blanks text))
  in
  let wrong = List.filter_map Fun.id (List.mapi check row.cells) in
  let texts = List.map (fun (c : Csv.cell) -> c.text) row.cells in
  if List.hd texts <> "time" && Dialect.separator_hint dialect texts <> None then
    reject [ List.hd wrong ];
  let width = List.length row.cells in
  let place (column : Shape.column) =
    match Hashtbl.find_opt places column.name with
    | Some place -> Either.Left (column, Cell place)
    | None when column.at_rest <> None -> Either.Left (column, At_rest (Option.get column.at_rest))
    | None -> Either.Right column.name
  in
  let found, missing = List.partition_map place columns in
  let missing =
    if missing = [] then []
    else
      let names = List.map (fun (c : Shape.column) -> c.name) columns in
      [
        complaint name row width "missing: %s; the header for this program is `%s`%s"
          (shortened (List.map (Printf.sprintf "`%s`") missing))
          (String.concat "," ("time" :: names))
          (Dialect.column_hint ~missing:(List.hd missing) ~unknown:!unknown);
      ]
  in
  if wrong <> [] || missing <> [] then reject (wrong @ missing);
  { width; time_cell; columns = found }

(* {1 Time} *)

(* Converts seconds to whole nanoseconds, exactly, rounding ties away from zero. Uses decimal
   arithmetic, because a double has too few digits for a year in nanoseconds. *)
let most_seconds = 4_000_000_000

let nanoseconds text =
  let n = String.length text in
  let rec digits k = if k < n && text.[k] >= '0' && text.[k] <= '9' then digits (k + 1) else k in
  let sign k = if k < n && (text.[k] = '-' || text.[k] = '+') then k + 1 else k in
  let start = sign 0 in
  let point = digits start in
  let stop = if point < n && text.[point] = '.' then digits (point + 1) else point in
  let exponent =
    if stop = n then Some 0
    else if text.[stop] <> 'e' && text.[stop] <> 'E' then None
    else
      let first = sign (stop + 1) in
      let last = digits first in
      if first = last || last < n then None
      else
        (* Clamp the exponent: if it is above a million, the number is 0 or out of range in any
           case. *)
        let raised = float_of_string ("0" ^ String.sub text first (last - first)) in
        let raised = int_of_float (Float.min raised 1e6) in
        Some (if text.[stop + 1] = '-' then -raised else raised)
  in
  let limit = most_seconds * 1_000_000_000 in
  (* [place] is the decimal exponent of the digit at index [k]. *)
  let rec add ns place k =
    if k = stop || place < -10 then raise_places ns place
    else if text.[k] = '.' then add ns place (k + 1)
    else
      let digit = Char.code text.[k] - Char.code '0' in
      if place = -10 then Some (if digit >= 5 then ns + 1 else ns)
      else if ns > limit / 10 then None
      else add ((ns * 10) + digit) (place - 1) (k + 1)
  and raise_places ns place =
    if ns = 0 || place < -9 then Some ns
    else if ns > limit / 10 then None
    else raise_places (ns * 10) (place - 1)
  in
  let count = stop - start - if stop > point then 1 else 0 in
  match exponent with
  | Some raised when count > 0 -> (
      match add 0 (point - start + raised - 1) start with
      | Some ns when ns <= limit -> Some (if text.[0] = '-' then -ns else ns)
      | Some _ | None -> None)
  | Some _ | None -> None

(* A time since 1970 in a smaller unit can be recognized by its size: the current time is about
   1.8e9 s. *)
let other_unit seconds =
  let looks_like unit_ factor =
    Printf.sprintf ": this looks like %s, so divide the times by %s" unit_ factor
  in
  if seconds > 1e11 && seconds < 1e14 then looks_like "milliseconds" "1e3"
  else if seconds >= 1e14 && seconds < 1e17 then looks_like "microseconds" "1e6"
  else if seconds >= 1e17 && seconds < 1e20 then looks_like "nanoseconds" "1e9"
  else ""

let too_far text =
  match float_of_string_opt text with
  | Some seconds
    when Float.abs seconds > float_of_int most_seconds
         && String.for_all (fun c -> String.contains "0123456789.+-eE" c) text ->
      Printf.sprintf "; the maximum is %d s%s" most_seconds (other_unit (Float.abs seconds))
  | Some _ | None -> ""

let stamp ns =
  Printf.sprintf "%s%d.%09d"
    (if ns < 0 then "-" else "")
    (abs ns / 1_000_000_000)
    (abs ns mod 1_000_000_000)

(* The difference between two times, which may exceed the range of [int]. *)
let seconds_between before now =
  Int64.to_float (Int64.sub (Int64.of_int now) (Int64.of_int before)) /. 1e9

(* {1 Rows} *)

let translated dialect header (row : Csv.row) =
  let cell (c : Csv.cell) = { c with text = Dialect.cell dialect c.text } in
  if dialect = Dialect.ours then row
  else { row with cells = List.map cell (Dialect.to_front header.time_cell row.cells) }

let read_row name ~dialect ~frames header (row : Csv.row) =
  if List.length row.cells <> header.width then
    reject
      [
        complaint name row header.width
          "wrong number of cells: the header has %d columns, but this row has %d%s" header.width
          (List.length row.cells)
          (Dialect.width_hint dialect ~width:header.width ~cells:(List.length row.cells));
      ];
  let cells = Array.of_list row.cells in
  let time =
    match nanoseconds cells.(0).text with
    | Some time -> time
    | None ->
        let text = cells.(0).text in
        reject
          [
            complaint name row 0 "`%s` is not a time in seconds%s%s%s" text (on_blanks text)
              (Dialect.number_hint dialect text)
              (too_far text);
          ]
  in
  let read_cell (column : Shape.column) place =
    match Cell.read ~frames column.shape cells.(place).text with
    | Ok value -> value
    | Error expected ->
        let text = cells.(place).text in
        let found =
          if String.for_all (fun c -> c = ' ' || c = '\t') text then "an empty cell"
          else "`" ^ text ^ "`" ^ Dialect.number_hint dialect text
        in
        reject
          [
            complaint name row place "column `%s`: expected %s, found %s" column.name expected found;
          ]
  in
  let read (column, place) =
    match place with Cell place -> read_cell column place | At_rest value -> value
  in
  (time, List.map read header.columns)

let quoted cell =
  if String.contains cell ',' || String.contains cell '"' then
    "\"" ^ String.concat "\"\"" (String.split_on_char '"' cell) ^ "\""
  else cell

let line cells = String.concat "," cells ^ "\n"

(* The columns of the output, and a function that returns the cells of one instant. If the program
   can end, the event that signals the end gets its own columns: [out.result] if the output is a
   record, otherwise [out.2]. *)
let outputs core execution output =
  match Execution.ended execution with
  | None -> (Shape.columns "out" output, Shape.cells output)
  | Some ended ->
      let event = Shape.of_type core (Core.Signature.event ended) in
      let is_record =
        match output with Shape.Data { constructors = [ c ]; _ } -> Shape.is_record c | _ -> false
      in
      let columns =
        if is_record then Shape.columns "out" output @ Shape.columns "out.result" event
        else Shape.columns "out.1" output @ Shape.columns "out.2" event
      in
      let cells : Value.t -> Value.t list = function
        | Tuple [| value; event |] ->
            Shape.cells output (Thunk.demand value) @ [ Thunk.demand event ]
        | _ -> Basis.Diagnostic.bug ~stage:"Interp" "a program that ends without a result"
      in
      (columns, cells)

(* Adds columns for the marks of drawings. A single drawing is named [draw]; several are
   numbered. *)
let with_drawings core execution ~marks output (columns, cells) =
  let mark = Shape.of_type core Core.Signature.(event mark) in
  let kind = Shape.Array (marks, mark) in
  let count = Shape.count_drawings output in
  let name k = if count = 1 then "probe.draw" else Printf.sprintf "probe.draw.%d" (k + 1) in
  let drawn = List.concat (List.init count (fun k -> Shape.columns (name k) kind)) in
  let event mark : Value.t = Data { constructor = 1; arguments = [| mark |] } in
  let no_event : Value.t = Data { constructor = 0; arguments = [||] } in
  let slots all =
    let all = List.map event all in
    all @ List.init (marks - List.length all) (fun _ -> no_event)
  in
  let command (value : Value.t) =
    match (Execution.ended execution, value) with
    | Some _, Tuple [| value; _ |] -> Thunk.demand value
    | _, value -> value
  in
  let drawings value = List.concat_map slots (Shape.drawings output (command value)) in
  (columns @ drawn, fun value -> cells value @ drawings value)

let instants execution ~name ~dialect ~frames ~csv ~header ~write ~input (columns, cells) =
  let rec from before =
    match next_row name csv with
    | None -> ()
    | Some row ->
        let row = translated dialect header row in
        let now, read = read_row name ~dialect ~frames header row in
        let before = Option.value before ~default:now in
        if now < before then
          reject
            [
              complaint name row 0 "the time goes backwards: `%s` comes after a later time"
                (List.hd row.cells).text;
            ];
        let result =
          Execution.instant execution ~seconds:(seconds_between before now)
            (Shape.assemble input read)
        in
        let written =
          List.map2
            (fun (column : Shape.column) value -> quoted (Cell.write column.shape value))
            columns (cells result)
        in
        write (line (stamp now :: written));
        from (Some now)
  in
  from None

(* Skips the parameter lines. Returns the first row after them, and the parameters they set. *)
let rec after_params core ~params ~name ~warn csv found =
  let row = next_row name csv in
  Option.iter (check_line_ends name) row;
  match row with
  | Some { cells = { text; _ } :: _; _ } when Recorded_params.is_line text -> (
      let settings, word = Recorded_params.read core ~set:params text in
      Option.iter (fun word -> warn (name ^ ": " ^ word)) word;
      match settings with
      | Ok settings -> after_params core ~params ~name ~warn csv (settings @ found)
      | Error wrong ->
          reject
            [ Printf.sprintf "%s: %s; to override the recorded value, use `--param`" name wrong ])
  | row -> (row, found)

let run ?(marks = 0) ?(params = []) ?(warn = ignore) ?(dialect = Dialect.ours) core ~entry ~name
    ~read ~write =
  let input, output = Execution.interface core entry in
  let input = Shape.of_type core input and output = Shape.of_type core output in
  let csv = Csv.reader ~separator:dialect.separator read in
  match
    let row, recorded = after_params core ~params ~name ~warn csv [] in
    let header =
      match row with
      | Some row -> header name ~dialect (Shape.columns "in" input) row
      | None ->
          let end_ : Csv.row = { line = Csv.line csv; cells = [] } in
          reject
            [
              complaint name end_ 0
                "the file is empty: its first line must name the columns, `time` first";
            ]
    in
    let execution = Execution.start ~params:(params @ recorded) core ~entry in
    let outputs = outputs core execution output in
    let outputs =
      if marks = 0 then outputs else with_drawings core execution ~marks output outputs
    in
    write (line ("time" :: List.map (fun (c : Shape.column) -> c.name) (fst outputs)));
    let frames = Kernels.frames ~record:name in
    instants execution ~name ~dialect ~frames ~csv ~header ~write ~input outputs
  with
  | () -> Ok ()
  | exception Rejected texts -> Error texts
