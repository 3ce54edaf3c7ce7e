(** How many marks a program can draw in an instant.

    Reads a program in which a drawing has room for one mark: an array of an [Event Mark], which
    only the library's primitives make. A mark is added by replacing an element; what else is done
    with drawings leaves them as they are, so the most marks that there can be in any value are
    found by going round until nothing grows. The marks of a second drawing are added as one
    element, of as many marks. *)

val limit : int

val most : Ir.program -> int option
(** [None]: more than {!limit}, or without bound. *)
