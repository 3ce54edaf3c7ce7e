(** Parses text into {!Ir}.

    The parser reads one top-level item at a time. Each faulty item gets its own message, and the
    others are still parsed. *)

open Basis

val readable : file:string -> string -> Ir.program option
(** The items of the text that do not contain errors. [None] if the items cannot be separated. *)

val program : Diagnostic.sink -> file:string -> string -> Ir.program option
(** [program sink ~file text] parses the text, which may contain arbitrary bytes, in linear time.
    [file]: the name shown in messages. [None] if an error was reported. *)
