(** Generated C in this process: libtcc compiles it quickly, and running it writes no files. *)

type t

val compile : headers:string -> folder:string -> string list -> (t, string) result
(** Compiles C files of the folder. The error is the C compiler's message. *)

val run : t -> real:Basis.Real.t -> Recording.t -> (string, string) result
(** Returns the trace of the output, as {!Recording.trace} writes it. [real] is the program's
    precision. The error says that the program crashes, does not terminate, or computes something
    else after a reset or with [NAME_step] instead of the step in the table. *)

val release : t -> unit
(** Frees the code, which must not be used afterwards. *)
