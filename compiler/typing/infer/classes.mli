(** What the classes of types need: the built-in ones hold structurally, for data without functions,
    signal functions and labels; the others where an instance says so.

    Codes: [E0307] no equality or order · [E0308] a class needed of a type that nothing decides ·
    [E0309] missing in a signature's context · [E0360] no instance. *)

open Context

val give : t -> Type.scheme -> unit
(** Inside the definition that has this signature its context holds. *)

val solve : t -> Generalize.t -> (Ir.class_ * Type.t) list
(** Answers all that the group needs. The variables are those that were generalized without a
    signature: what they need is returned, as the context of the group's schemes. *)
