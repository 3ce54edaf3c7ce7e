(** Messages about declarations: units ([E0324]), program parameters ([E0390]), and the declarations
    covered by {!Foreign_type_mistake} and {!Class_mistake}. *)

open Basis

val diagnostic : Wording.t -> Typing.Declaration_fact.t -> Diagnostic.t
