(** Checks what {!Ir} promises: every local variable is bound once and used in its scope; every
    global name, type, constructor and unit exists, with the right number of arguments; types and
    units come before their users. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
