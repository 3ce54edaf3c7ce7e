(** From text to {!Ir}.

    Reads item by item at the top level, so that each faulty item has its own message and the others
    are still read. *)

open Basis

val readable : file:string -> string -> Ir.program option
(** Of a text with mistakes the items without; [None] if even these are not to be told apart. *)

val program : Diagnostic.sink -> file:string -> string -> Ir.program option
(** [program sink ~file text]: [file] is the name to show. [None] if anything was reported as an
    error. Takes any bytes, in linear time. *)
