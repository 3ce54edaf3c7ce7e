(** No definition may be needed to evaluate itself.

    Of functions and signal functions everything is evaluated while compiling, which ends only if
    none of them calls itself, directly or through others. What is used later, in a continuation,
    does not count, unless it is needed at ever larger types. *)

open Basis

val check : Diagnostic.sink -> Ir.program -> unit
(** Emits E0410 for each cycle; see {!Method_recursion} and {!Polymorphic_recursion}. Linear. Does
    not need what {!Lint} checks. *)
