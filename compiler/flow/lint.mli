(** Checks the invariants of {!Ir}: each signal has one equation, in the node that uses it; callees
    come before callers; operations and instances have the right types; constructors exist;
    functions have no state; names are unique. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
