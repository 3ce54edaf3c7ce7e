(** Messages about the controls of the operator's console: labels ([E0440]), values ([E0441]), and
    two controls with the same label ([E0442]). *)

open Basis

val diagnostic : Specialize.Control_fact.t -> Diagnostic.t
