(** Decides which items a node computes when it starts, and which in each instant.

    A signal is static if it depends only on the node's static parameters and on constants, through
    operations and functions. Since a static signal never changes, the reset computes the signal and
    stores it in the state, if the step reads it and if its computation calls a function or the C
    library. Any other static signal is computed where it is read, because that costs less than
    storing it. The levels of the source language guarantee that the [init] of a [Delay] and the
    [statics] of an instance are static. A [Function] node has no state and no reset: the step
    computes everything. *)

type t = {
  at_reset : Flow.Schedule.item list;
      (** items that compute the initial values of delays, the static arguments of instances, and
          [kept], in order *)
  kept : Flow.Ir.signal list;
      (** signals computed in the reset and stored in the state for the step *)
  in_step : Flow.Schedule.item list;
      (** items that compute the outputs and the state, in order, except for [kept]; cheap static
          items may also be in [at_reset] *)
  read_by_step : Flow.Ir.signal list;
      (** static parameters of the node that the step needs as arguments, for itself or for its
          instances *)
}

val program : Flow.Ir.program -> t array
(** Returns one result for each node. Raises {!Basis.Diagnostic.Bug} if an initial value or a static
    argument of an instance is not static. *)

val equations_in_step : t -> Flow.Ir.equation list
(** The equations among the items [in_step]. *)
