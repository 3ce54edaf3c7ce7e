type t

external compile_files : string array -> string array -> t = "in_process_compile"
external run_rows : t -> int array -> string array array -> string = "in_process_run"
external release : t -> unit = "in_process_release"

(* Where tcc 0.9.27 receives a struct that a function returns in registers, it
   writes whole registers: if the struct's size is no multiple of theirs, over the
   variable beside it. So all structs get such a size. *)
let with_whole_registers text =
  let starts_struct line =
    String.starts_with ~prefix:"struct " line && String.ends_with ~suffix:"{" line
  in
  let rec go after_start = function
    | [] -> []
    | line :: lines ->
        let line = if after_start then "_Alignas(8) " ^ String.trim line else line in
        line :: go (starts_struct line) lines
  in
  String.concat "\n" (go false (String.split_on_char '\n' text))

let compile ~headers ~folder files =
  match compile_files [| headers; folder |] (Array.of_list files) with
  | program -> Ok program
  | exception Failure text -> Error text

let run program recording =
  let rows = Recording.rows recording in
  let times = List.map (fun (r : Recording.row) -> r.time_ns) rows in
  let cells = List.map (fun (r : Recording.row) -> Array.of_list r.cells) rows in
  match run_rows program (Array.of_list times) (Array.of_list cells) with
  | trace -> Ok trace
  | exception Failure text -> Error text
