(** No definition may be needed to evaluate itself.

    Of functions and signal functions everything is evaluated while compiling,
    which ends only if none of them calls itself, directly or through others. What is mentioned in a function
    that gives a signal function and is passed as an argument, as the
    continuation of a switch is, does not count here. *)

open Basis

val check : Diagnostic.sink -> Core.Ir.program -> unit
(** Emits E0410 for each cycle. Linear. Does not need what {!Core.Lint}
    checks. *)
