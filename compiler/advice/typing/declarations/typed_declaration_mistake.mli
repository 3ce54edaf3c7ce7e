(** Messages about declarations: units ([E0324]), parameters of the program ([E0390]), and those of
    {!Foreign_type_mistake} and {!Class_mistake}. *)

open Basis

val diagnostic : Wording.t -> Typing.Declaration_fact.t -> Diagnostic.t
