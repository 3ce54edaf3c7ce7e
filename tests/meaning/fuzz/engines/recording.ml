type row = { time_ns : int; dt : float option; value : Interp.Value.t; cells : string list }
type param = { line : string; cell : string; setting : Core.Ir.Global.t * Interp.Value.t }
type t = { shape : Interp.Shape.t; precision : Basis.Real.t; rows : row list; params : param list }

let cells columns shape value =
  List.map2
    (fun (c : Interp.Shape.column) value -> Interp.Cell.write c.shape value)
    columns (Interp.Shape.cells shape value)

let make shape values =
  let columns = Interp.Shape.columns "in" shape in
  let row (time_ns, value) = { time_ns; dt = None; value; cells = cells columns shape value } in
  { shape; precision = Double; rows = List.map row values; params = [] }

(* Their output has row numbers in place of times. *)
let with_dt precision shape values =
  let columns = Interp.Shape.columns "in" shape in
  let row k (dt, value) =
    { time_ns = k * 1_000_000_000; dt = Some dt; value; cells = cells columns shape value }
  in
  { shape; precision; rows = List.mapi row values; params = [] }

let has_shape shape recording = shape = recording.shape

(* Parses the rows of a CSV file, without its header. *)
let read_rows shape first (rows : Interp.Csv.row list) =
  let columns = Interp.Shape.columns "in" shape in
  let cell (c : Interp.Shape.column) text =
    match Interp.Cell.read c.shape text with
    | Ok value -> value
    | Error expected -> failwith (Printf.sprintf "expected %s, found `%s`" expected text)
  in
  let time text =
    match String.split_on_char '.' text with
    | [ whole; decimals ] when String.length decimals = 9 ->
        (int_of_string whole * 1_000_000_000) + int_of_string ("0u" ^ decimals)
    | _ -> failwith (Printf.sprintf "expected a time with nine decimals, found `%s`" text)
  in
  let row of_stamp (row : Interp.Csv.row) =
    match List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells with
    | stamp :: cells when List.length cells = List.length columns ->
        (of_stamp stamp, Interp.Shape.assemble shape (List.map2 cell columns cells))
    | _ -> failwith "a row has other columns"
  in
  match first with
  | "dt" -> with_dt Double shape (List.map (row float_of_string) rows)
  | "dt_float" -> with_dt Single shape (List.map (row float_of_string) rows)
  | _ -> make shape (List.map (row time) rows)

let read shape text =
  let next = ref 0 in
  let characters () =
    incr next;
    if !next > String.length text then None else Some text.[!next - 1]
  in
  let csv = Interp.Csv.reader characters in
  let rec all found =
    match Interp.Csv.next csv with
    | Ok (Some row) -> all (row :: found)
    | Ok None -> List.rev found
    | Error _ -> failwith "this is no CSV file"
  in
  let is_row (row : Interp.Csv.row) =
    match row.cells with
    | { text; _ } :: _ -> not (Interp.Recorded_params.is_line text)
    | [] -> true
  in
  match List.filter is_row (all []) with
  | [] -> Error "the file is empty"
  | { cells = { text; _ } :: _; _ } :: rows -> Ok (read_rows shape text rows)
  | { cells = []; _ } :: _ -> Error "the first line is empty"
  | exception Failure text -> Error text

let rows recording = recording.rows
let params recording = recording.params
let with_params params recording = { recording with params }
let precision recording = recording.precision
let has_dt recording = List.exists (fun row -> Option.is_some row.dt) recording.rows

(* Programs must ignore the first dt, so it may be any number. *)
let seconds recording =
  let of_row before row =
    let since =
      match (row.dt, before) with
      | Some dt, _ -> dt
      | None, None -> 123.456
      | None, Some before -> float_of_int (row.time_ns - before) /. 1e9
    in
    (Some row.time_ns, since)
  in
  snd (List.fold_left_map of_row None recording.rows)

let first_rows n t = { t with rows = List.filteri (fun i _ -> i < n) t.rows }
let without k t = { t with rows = List.filteri (fun i _ -> i <> k) t.rows }
let quoted cell = if String.contains cell ',' then "\"" ^ cell ^ "\"" else cell
let line cells = String.concat "," cells ^ "\n"
let stamp ns = Printf.sprintf "%d.%09d" (ns / 1_000_000_000) (ns mod 1_000_000_000)
let header first columns = line (first :: List.map (fun (c : Interp.Shape.column) -> c.name) columns)
let row first cells = line (first :: List.map quoted cells)

let csv ({ shape; precision; rows; params } as recording) =
  let first =
    match precision with
    | Single -> "dt_float"
    | Double -> if has_dt recording then "dt" else "time"
  in
  let row { time_ns; dt; cells; _ } =
    row (Option.fold dt ~none:(stamp time_ns) ~some:(Printf.sprintf "%.17g")) cells
  in
  let head = List.map (fun p -> p.line ^ "\n") params in
  String.concat "" (head @ (header first (Interp.Shape.columns "in" shape) :: List.map row rows))

let trace shape values =
  let columns = Interp.Shape.columns "out" shape in
  let row (time_ns, value) = row (stamp time_ns) (cells columns shape value) in
  String.concat "" (header "time" columns :: List.map row values)
