(** Warnings about a typed program: those of {!Constant_warning} and {!Wrapped_angle_warning},
    thresholds that no reading reaches ([W0310]), and divisions by the length of the step ([W0314]).
*)

open Basis

val diagnostic : Source.t -> Typing.Warning_fact.t -> Diagnostic.t
