(** The first instant apart, where it is short.

    At the first instant dt is 0, the state is what the reset left, and [atStart] holds:
    with that known, most of a step comes to nothing. What remains stands in a branch of
    its own where it is no more than a few assignments of state; then the step asks once
    whether it is the first, and the other branch knows that it is not:

    {v
    if (!self->started) {
        self->started = true;
        self->before = in->button;
    } else {
        …
    }
    out->value = self->before;
    v} *)

open Basis

val step :
  Real.t ->
  started:Ir.field ->
  reset:Ir.statement list ->
  Ir.statement list ->
  Ir.statement list option
(** The body of the root's step, whose first instant a delay of the program marks:
    an [If] by [started], whose branch for later instants alone looks at dt, and what
    comes after it. [None] if that would be no shorter. *)
