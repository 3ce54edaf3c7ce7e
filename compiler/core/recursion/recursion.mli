(** Reports definitions that cannot be evaluated because they depend on themselves.

    All functions and signal functions are evaluated at compile time. That terminates only if none
    of them calls itself, directly or through others. Uses in a continuation happen later and do not
    count, unless they require ever larger types. *)

open Basis

val facts : Ir.program -> Fact.t list
(** Reports each cycle; see also {!Method_recursion} and {!Polymorphic_recursion}. Takes linear
    time. Does not depend on the invariants that {!Lint} checks. *)

val check : Fact.t Facts.t -> Ir.program -> unit
(** Reports the {!facts}. *)
