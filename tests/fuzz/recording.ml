type row = { time_ns : int; value : Interp.Value.t; cells : string list }
type t = { shape : Interp.Shape.t; rows : row list }

let cells columns shape value =
  List.map2
    (fun (c : Interp.Shape.column) value -> Interp.Cell.write c.shape value)
    columns (Interp.Shape.cells shape value)

let make shape values =
  let columns = Interp.Shape.columns "in" shape in
  let row (time_ns, value) = { time_ns; value; cells = cells columns shape value } in
  { shape; rows = List.map row values }

let has_shape shape recording = shape = recording.shape

(* Of a CSV file's rows, the header left out. *)
let read_rows shape (rows : Interp.Csv.row list) =
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
  let row (row : Interp.Csv.row) =
    match List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells with
    | stamp :: cells when List.length cells = List.length columns ->
        (time stamp, Interp.Shape.assemble shape (List.map2 cell columns cells))
    | _ -> failwith "a row has other columns"
  in
  make shape (List.map row rows)

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
  match all [] with
  | [] -> Error "the file is empty"
  | _ :: rows -> Ok (read_rows shape rows)
  | exception Failure text -> Error text

let rows recording = recording.rows
let first_rows n t = { t with rows = List.filteri (fun i _ -> i < n) t.rows }
let without k t = { t with rows = List.filteri (fun i _ -> i <> k) t.rows }
let quoted cell = if String.contains cell ',' then "\"" ^ cell ^ "\"" else cell
let line cells = String.concat "," cells ^ "\n"

let stamp ns = Printf.sprintf "%d.%09d" (ns / 1_000_000_000) (ns mod 1_000_000_000)

let header columns = line ("time" :: List.map (fun (c : Interp.Shape.column) -> c.name) columns)
let row time_ns cells = line (stamp time_ns :: List.map quoted cells)

let csv { shape; rows } =
  let row { time_ns; cells; _ } = row time_ns cells in
  String.concat "" (header (Interp.Shape.columns "in" shape) :: List.map row rows)

let trace shape values =
  let columns = Interp.Shape.columns "out" shape in
  let row (time_ns, value) = row time_ns (cells columns shape value) in
  String.concat "" (header columns :: List.map row values)
