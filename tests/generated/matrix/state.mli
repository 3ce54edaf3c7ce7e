(** Generates C that reads a program's state field by field, so that compilers and machines with
    different layouts can be compared. *)

val text : Step.Ir.program -> string
(** The file that defines [hash_state] of expected.h. For a state machine it reads only the running
    mode, because the other modes share its memory. It skips user-defined C components. *)
