(* What the header says: the input's columns, each with its place in the rows. *)
type header = { width : int; columns : (Shape.column * place) list }

(* A column of the console may be left out. *)
and place = Cell of int | At_rest of Value.t

exception Rejected of string list

let complaint name (row : Csv.row) cell format =
  let column = match List.nth_opt row.cells cell with Some { column; _ } -> column | None -> 1 in
  Printf.ksprintf (Printf.sprintf "%s:%d:%d: %s" name row.line column) format

(* What to add to a message on a column's name or a time: blanks beside commas
   belong to it, and are hard to see. *)
let on_blanks text =
  let blank i = text.[i] = ' ' || text.[i] = '\t' in
  if text <> "" && (blank 0 || blank (String.length text - 1)) then
    "; leave no blanks beside the commas"
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
            (List.length row.cells - 1, "a blank before a quote; leave no blanks beside the commas")
        | Zero_byte -> (0, "a zero byte: this is not a CSV file")
      in
      reject [ complaint name row cell "%s" text ]

(* {1 The header} *)

(* Recordings have the output too. *)
let is_output column =
  let starts prefix =
    String.length column >= String.length prefix
    && String.equal prefix (String.sub column 0 (String.length prefix))
  in
  String.equal column "out" || starts "out." || starts "out[" || starts "mode." || starts "probe."

(* The header that is wanted follows: of a robot's input the names are many. *)
let shortened names =
  let most = 4 in
  if List.length names <= most then String.concat ", " names
  else
    Basis.Enumeration.some
      (List.filteri (fun i _ -> i < most - 1) names)
      ~more:(List.length names - most + 1)

let header name columns (row : Csv.row) =
  let known = Hashtbl.create 64 and places = Hashtbl.create 64 in
  List.iter (fun (c : Shape.column) -> Hashtbl.replace known c.name ()) columns;
  let complain cell format =
    Printf.ksprintf (fun text -> Some (complaint name row cell "%s" text)) format
  in
  let check i ({ text; _ } : Csv.cell) =
    if i = 0 then
      if String.equal text "time" then None
      else complain i "the first column must be `time`, but it is `%s`%s" text (on_blanks text)
    else if Hashtbl.mem places text then complain i "column `%s` is there twice" text
    else if Hashtbl.mem known text then (
      Hashtbl.replace places text i;
      None)
    else if is_output text then None
    else complain i "the program's input has no `%s`%s" text (on_blanks text)
  in
  let wrong = List.filter_map Fun.id (List.mapi check row.cells) in
  let width = List.length row.cells in
  let place (column : Shape.column) =
    match Hashtbl.find_opt places column.name with
    | Some place -> Either.Left (column, Cell place)
    | None when column.at_rest <> None -> Either.Left (column, At_rest (Option.get column.at_rest))
    | None -> Either.Right (Printf.sprintf "`%s`" column.name)
  in
  let found, missing = List.partition_map place columns in
  let missing =
    if missing = [] then []
    else
      let names = List.map (fun (c : Shape.column) -> c.name) columns in
      [
        complaint name row width "missing: %s; the header for this program is `%s`"
          (shortened missing)
          (String.concat "," ("time" :: names));
      ]
  in
  if wrong <> [] || missing <> [] then reject (wrong @ missing);
  { width; columns = found }

(* {1 Time} *)

(* Seconds as whole nanoseconds, exactly, halves away from zero: in decimal
   arithmetic, for a double has too few digits for a year of them. *)
let nanoseconds text =
  let plain =
    if not (String.exists (fun c -> c = 'e' || c = 'E') text) then Some text
    else
      match float_of_string_opt text with
      | Some seconds when (not (String.contains text '_')) && Float.abs seconds < 1e9 ->
          Some (Printf.sprintf "%.12f" seconds)
      | Some _ | None -> None
  in
  let is_number digits = String.for_all (fun c -> '0' <= c && c <= '9') digits in
  let unsigned negative digits =
    let whole, decimals =
      match String.index_opt digits '.' with
      | None -> (digits, "")
      | Some i -> (String.sub digits 0 i, String.sub digits (i + 1) (String.length digits - i - 1))
    in
    if not (is_number whole && is_number decimals && whole ^ decimals <> "") then None
    else
      let significant = String.sub (decimals ^ "000000000") 0 9 in
      let rounds_up = String.length decimals > 9 && decimals.[9] >= '5' in
      match int_of_string_opt ("0" ^ whole) with
      | Some seconds when seconds <= 1_000_000_000 ->
          let below = (seconds * 1_000_000_000) + int_of_string significant in
          let ns = if rounds_up then below + 1 else below in
          Some (if negative then -ns else ns)
      | Some _ | None -> None
  in
  let rest text = String.sub text 1 (String.length text - 1) in
  match plain with
  | None | Some "" -> None
  | Some text -> (
      match text.[0] with
      | '-' -> unsigned true (rest text)
      | '+' -> unsigned false (rest text)
      | _ -> unsigned false text)

let stamp ns =
  Printf.sprintf "%s%d.%09d"
    (if ns < 0 then "-" else "")
    (abs ns / 1_000_000_000)
    (abs ns mod 1_000_000_000)

(* {1 Rows} *)

let read_row name ~frames header (row : Csv.row) =
  if List.length row.cells <> header.width then
    reject
      [
        complaint name row header.width "the header names %d columns, but cells in this row: %d%s"
          header.width (List.length row.cells)
          (if List.length row.cells > header.width then
             "; a cell with a comma in it stands in double quotes"
           else "");
      ];
  let cells = Array.of_list row.cells in
  let time =
    match nanoseconds cells.(0).text with
    | Some time -> time
    | None ->
        let text = cells.(0).text in
        reject [ complaint name row 0 "`%s` is not a time in seconds%s" text (on_blanks text) ]
  in
  let read_cell (column : Shape.column) place =
    match Cell.read ~frames column.shape cells.(place).text with
    | Ok value -> value
    | Error expected ->
        let text = cells.(place).text in
        let found =
          if String.for_all (fun c -> c = ' ' || c = '\t') text then "an empty cell"
          else "`" ^ text ^ "`"
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

(* The columns of the output, and the cells of an instant's. The event of the
   program's end is one more field of a record. *)
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

(* With the marks that are drawn: one drawing is [draw], of several each has a number. *)
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

let instants execution ~name ~frames ~csv ~header ~write ~input (columns, cells) =
  let rec from before =
    match next_row name csv with
    | None -> ()
    | Some row ->
        let now, read = read_row name ~frames header row in
        let since = match before with Some before -> now - before | None -> 0 in
        if since < 0 then
          reject
            [
              complaint name row 0 "time goes back: `%s` comes after a later time"
                (List.hd row.cells).text;
            ];
        let result =
          Execution.instant execution
            ~seconds:(float_of_int since /. 1e9)
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

(* The first row that is one, and what the lines before it set parameters to. *)
let rec after_params core ~params ~name ~warn csv found =
  match next_row name csv with
  | Some { cells = { text; _ } :: _; _ } when Recorded_params.is_line text -> (
      let settings, word = Recorded_params.read core ~set:params text in
      Option.iter (fun word -> warn (name ^ ": " ^ word)) word;
      match settings with
      | Ok settings -> after_params core ~params ~name ~warn csv (settings @ found)
      | Error wrong ->
          reject [ Printf.sprintf "%s: %s; `--param` sets it whatever was recorded" name wrong ])
  | row -> (row, found)

let run ?(marks = 0) ?(params = []) ?(warn = ignore) core ~entry ~name ~read ~write =
  let input, output = Execution.interface core entry in
  let input = Shape.of_type core input and output = Shape.of_type core output in
  let csv = Csv.reader read in
  match
    let row, recorded = after_params core ~params ~name ~warn csv [] in
    let header =
      match row with
      | Some row -> header name (Shape.columns "in" input) row
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
    instants execution ~name ~frames:(Kernels.frames ~record:name) ~csv ~header ~write ~input
      outputs
  with
  | () -> Ok ()
  | exception Rejected texts -> Error texts
