(** Generated C in this process: compiled by libtcc, which is quick, and run with nothing written to
    a file in between. *)

type t

val for_tcc : string -> string
(** Generated C such as tcc compiles rightly. *)

val compile : headers:string -> folder:string -> string list -> (t, string) result
(** Of C files in the folder; the error is what the C compiler says. *)

val run : t -> Recording.t -> (string, string) result
(** The trace of the output, as {!Recording.trace} writes it. The error says that the program
    crashes or does not come to an end. *)

val release : t -> unit
(** Gives the memory of the code back; it is not to be used after that. *)
