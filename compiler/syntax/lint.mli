(** Checks what {!Ir} promises. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
