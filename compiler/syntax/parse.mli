(** Parses text into {!Ir}.

    The parser reads one top-level item at a time. It reports each faulty item, and still parses the
    others. *)

open Basis

val readable : file:string -> string -> Ir.program option
(** The items of the text that do not contain errors. [None] if the items cannot be separated. *)

val program : Fact.t Facts.t -> file:string -> string -> Ir.program option
(** [program facts ~file text] parses the text, which may contain arbitrary bytes, in linear time.
    [file]: the name shown in messages. The result is [None] if a fact was reported. *)

val expects_more : Layout.token option -> bool
(** Is an expression, type or definition that ends with this token always incomplete? *)
