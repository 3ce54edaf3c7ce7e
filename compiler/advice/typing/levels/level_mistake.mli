(** Messages about levels: signal functions that run or are bound without being static ([E0340],
    [E0344]), recursive lets ([E0346]), and the mistakes covered by {!Misplaced_instance} and
    {!Index_mistake}. *)

open Basis

val diagnostic : Source.t -> Typing.Level_fact.t -> Diagnostic.t
