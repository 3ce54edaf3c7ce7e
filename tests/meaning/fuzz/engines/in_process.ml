type t

external compile_files : string array -> string array -> t = "in_process_compile"

external run_rows :
  t -> bool * bool * string array -> float array -> int array -> string array array -> string
  = "in_process_run"

external release : t -> unit = "in_process_release"

let compile ~headers ~folder files =
  match compile_files [| headers; folder |] (Array.of_list files) with
  | program -> Ok program
  | exception Failure text -> Error text

let run program ~(real : Basis.Real.t) recording =
  let rows = Recording.rows recording in
  let times = List.map (fun (r : Recording.row) -> r.time_ns) rows in
  let cells = List.map (fun (r : Recording.row) -> Array.of_list r.cells) rows in
  let singles = Recording.precision recording = Single in
  let params =
    Array.of_list (List.map (fun (p : Recording.param) -> p.cell) (Recording.params recording))
  in
  let dts = Array.of_list (Recording.seconds recording) in
  (* If only the program's own code is in single precision, NAME_step rounds to a float where the
     recording contains a double. *)
  let in_seconds = singles || real = Double in
  match
    run_rows program (singles, in_seconds, params) dts (Array.of_list times) (Array.of_list cells)
  with
  | trace -> Ok trace
  | exception Failure text -> Error text
