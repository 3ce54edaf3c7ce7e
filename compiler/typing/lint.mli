(** Checks the invariants of {!Ir} about names and types. Each variable is bound once and used in
    its scope. The type of each expression agrees with the types of its parts. Types mention only
    the parameters in scope.

    Instantiations and data types have their units erased, so their types are compared without
    units. {!Levels} and {!Patterns} ensure that levels are correct and cases exhaustive; that is
    not checked again here. *)

val program : Ir.program -> unit
(** @raise Basis.Diagnostic.Bug if an invariant is violated *)
