(** Checks the invariants of {!Ir}. Every local variable is bound once and used in its scope. Every
    global name, type, constructor and unit exists and has the right number of arguments. Types and
    units are declared before their uses. *)

val program : Ir.program -> unit
(** @raise Basis.Diagnostic.Bug if an invariant is violated *)
