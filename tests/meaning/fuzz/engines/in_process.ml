type t

external compile_files : string array -> string array -> t = "in_process_compile"

external run_rows :
  t -> bool * bool * string array -> float array -> int array -> string array array -> string
  = "in_process_run"

external release : t -> unit = "in_process_release"

(* Works around two bugs of tcc 0.9.27. When it receives a struct that a function returns in
   registers, it writes whole registers; if the struct's size is not a multiple of theirs, this
   overwrites the variable after it. So all structs are padded to a multiple. And it does not
   recognize a sum that contains NaN or infinity as a constant, so local tables become variables. *)
let for_tcc text =
  let starts_struct line =
    String.starts_with ~prefix:"struct " line && String.ends_with ~suffix:"{" line
  in
  let table = "static const " in
  let adapted after_start line =
    let indented = String.trim line in
    let is_local = String.length indented < String.length line in
    let from = String.length table in
    if after_start then "_Alignas(8) " ^ indented
    else if is_local && String.starts_with ~prefix:table indented then
      "const " ^ String.sub indented from (String.length indented - from)
    else line
  in
  let rec go after_start = function
    | [] -> []
    | line :: lines -> adapted after_start line :: go (starts_struct line) lines
  in
  String.concat "\n" (go false (String.split_on_char '\n' text))

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
