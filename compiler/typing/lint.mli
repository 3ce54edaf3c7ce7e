(** Checks what {!Ir} promises of names and types: each variable is bound once and used in its
    scope; each expression has the type that its parts give it; types are closed over the parameters
    in scope.

    Where instantiations and data types have had their units erased, types are compared but for
    their units. That levels are right and cases exhaustive is what {!Levels} and {!Patterns} see
    to, and is not checked again. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
