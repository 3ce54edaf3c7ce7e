(** Solves class constraints. A type has the built-in classes if it does not contain functions,
    signal functions or labels. It has any other class if there is an instance for it.

    Codes: [E0307] the type has no equality or order · [E0308] nothing determines the type for which
    a class is required · [E0309] the signature's context lacks a constraint · [E0360] there is no
    instance. *)

open Context

val give : t -> Type.scheme -> unit
(** Assumes the scheme's context inside the definition that has this signature. *)

val solve : t -> Generalize.t -> (Ir.class_ * Type.t) list
(** Solves the constraints of the group. Returns the constraints on the given variables, which were
    generalized without a signature. These constraints become the context of the group's schemes. *)
