(** Operations on constants, computed exactly as the generated C would.

    Nothing is folded whose result is the C library's ([sin], [pow] …), which
    may differ from machine to machine; [sqrt] is defined by IEEE. *)

val operation : Ir.operator -> Ir.atom list -> Ir.atom option
(** The constant that the operation gives, if all its arguments are constants
    and it can be known. *)
