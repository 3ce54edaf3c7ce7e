(** C that reads a program's state field by field, so that what compilers and machines make of it
    can be compared whatever its layout is there. *)

val text : Step.Ir.program -> string
(** The file that defines [hash_state] of expected.h. Of a machine the mode that runs is read, for
    the others' memory is the same; components of the user's C are not. *)
