type life = Outlives | Ends_with_us | Ends_with_all_it_started

external start_ : string array -> Unix.file_descr * Unix.file_descr * Unix.file_descr -> life -> int
  = "frobc_child_start"

external end_with : int -> string -> unit = "frobc_child_end_with"

let start life program arguments ~stdin ~stdout ~stderr =
  start_ (Array.of_list (program :: arguments)) (stdin, stdout, stderr) life

let asked_by = "FROBC_PARENT"

let end_with_parent () =
  match Option.bind (Sys.getenv_opt asked_by) int_of_string_opt with
  | Some parent -> end_with parent asked_by
  | None -> ()

external allow_stack : int -> unit = "frobc_child_allow_stack"
external put_stack_back : unit -> unit = "frobc_child_put_stack_back"
