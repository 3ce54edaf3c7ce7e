(** Runs generated C compiled and optimized by gcc and clang, with AddressSanitizer and
    UndefinedBehaviorSanitizer. Slow, so used for a few batches only. *)

type compiler = Gcc | Clang

val name : compiler -> string

val run :
  compiler ->
  runtime:string ->
  folder:string ->
  (string * string) list ->
  Recording.t list ->
  (string list, string) result
(** [run compiler ~runtime ~folder files recordings] compiles a program's files (names and contents)
    in the folder, and returns the traces of its output. [runtime] is the folder of the trace host's
    sources; the host is built once for each folder and compiler. *)
