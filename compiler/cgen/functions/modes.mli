(** Machines in C: the running mode is stepped in a [switch] by its number; where that enters
    another, the loop around the [switch] goes round once more. *)

open Basis

val enter : Context.t -> Step.Ir.entry -> Span.t -> Ir.statement list
(** The number, the parameters, and the state at its start. *)

val run : Context.t -> Step.Ir.run -> Ir.statement list
(** One instant, with the declarations of its results before it. *)
