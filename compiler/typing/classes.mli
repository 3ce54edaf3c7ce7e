(** The built-in classes: equality and order hold structurally, for data
    without functions, signal functions and labels.

    Codes: [E0307] no such class for a type · [E0308] a class needed of a type
    that nothing decides · [E0309] missing in a signature's context. *)

open Context

val give : Type.scheme -> unit
(** Inside the definition that has this signature its context holds. *)

val solve : t -> Type.rigid list -> (Ir.class_ * Type.t) list
(** Answers all that the group needs. The variables are those that were
    generalized without a signature: what they need is returned, as the
    context of the group's schemes. *)
