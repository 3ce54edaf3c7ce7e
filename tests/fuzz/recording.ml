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
