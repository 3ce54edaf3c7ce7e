(** Messages about signal functions and tasks that restart themselves: endlessly in one instant
    ([E0402]), inside themselves ([E0415]), ever larger ([E0416]), or before the statements that
    wait for the task ([E0420]). *)

open Basis

val diagnostic : Specialize.Restart_fact.t -> Diagnostic.t
