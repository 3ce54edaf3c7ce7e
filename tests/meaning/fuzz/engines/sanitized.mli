(** Generated C as gcc and clang optimize it, with the checks of AddressSanitizer and
    UndefinedBehaviorSanitizer. Slow: for now and then. *)

type compiler = Gcc | Clang

val name : compiler -> string

val run :
  compiler ->
  runtime:string ->
  folder:string ->
  (string * string) list ->
  Recording.t list ->
  (string list, string) result
(** [run compiler ~runtime ~folder files recordings]: the traces of the output, of a program's files
    (names with texts) in the folder. [runtime] holds the sources of the trace host, which is built
    once for each folder and compiler. *)
