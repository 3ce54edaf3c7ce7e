(** Checks the invariants of {!Ir}: one equation for each signal, in the node that uses it; callees
    before callers; types of operations and instances; constructors that exist; absence of state in
    functions; unique names. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
