(** Checks the invariants of {!Ir}. *)

val program : Ir.program -> unit
(** @raise Basis.Diagnostic.Bug if an invariant is violated *)
