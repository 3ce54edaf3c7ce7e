(** Generates machines: a [switch] on the number of the running mode calls its step. If a transition
    enters another mode, the loop around the [switch] runs another iteration. *)

open Basis

val enter : Context.t -> Step.Ir.entry -> Span.t -> Ir.statement list
(** Stores the mode's number and parameters, and resets its state. *)

val run : Context.t -> Step.Ir.run -> Ir.statement list
(** The declarations of the results, and the statements that run the machine for one instant. *)
