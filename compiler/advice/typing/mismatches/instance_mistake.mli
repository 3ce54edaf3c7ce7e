(** Messages about class constraints that are not satisfied: [E0307] the type has no equality or
    order · [E0308] nothing determines the type that needs an instance · [E0360] there is no
    instance · [E0371] a task is required; and those of {!Promise_mistake}. *)

open Basis

val diagnostic : Wording.t -> Typing.Instance_fact.t -> Diagnostic.t
