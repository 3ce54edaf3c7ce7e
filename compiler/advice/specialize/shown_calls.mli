(** The calls that lead to the place of a mistake. *)

open Basis

val label : Specialize.Calls.t -> Diagnostic.t -> Diagnostic.t
(** Labels the innermost calls, each place only once: that is enough to recognize an infinite
    recursion. *)
