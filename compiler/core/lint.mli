(** Checks the invariants of {!Ir}: each variable is bound once and used in scope; every expression
    is well typed; types mention only the type parameters in scope; constructors and fields exist.

    Not checked: that the constructor of a payload was tested, and that functions are not recursive
    (the specializer reports these). *)

val program : Ir.program -> unit
(** @raise Basis.Diagnostic.Bug if an invariant is violated *)
