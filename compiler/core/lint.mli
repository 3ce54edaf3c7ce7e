(** Checks what {!Ir} promises: scopes, one binding for each variable, and types, by a full type
    check of every expression; types closed over the type parameters in scope; constructors and
    fields that exist.

    Not checked: that a payload's constructor was tested, and that no function calls itself (the
    specializer reports those). *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
