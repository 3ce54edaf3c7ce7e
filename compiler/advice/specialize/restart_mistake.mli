(** Messages about signal functions and tasks that restart themselves: endlessly in one instant
    ([E0402]), inside themselves ([E0415]), with ever larger arguments ([E0416]), or while later
    statements wait for the task to end ([E0420]). *)

open Basis

val diagnostic : Specialize.Restart_fact.t -> Diagnostic.t
