(** Machines in C: the running mode is stepped in a [switch] by its number. What
    that enters is stepped there too if it does not end at once
    ({!Step.Direct}); else the loop around the [switch] goes round once more. *)

open Basis

val enter : Context.t -> Step.Ir.entry -> Span.t -> Ir.statement list
(** The number, the parameters, and the state at its start. *)

val await : Context.t -> Span.t -> Ir.statement list
(** The number that stands for no mode. *)

val begin_ : Context.t -> Step.Ir.run -> Step.Ir.entry -> Span.t -> Ir.statement list
(** The first instant of a machine that is in this mode in it, with the declarations of
    its results before it. *)

val run : Context.t -> Step.Ir.run -> Ir.statement list
(** One instant, with the declarations of its results before it. *)
