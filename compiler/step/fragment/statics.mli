(** What a node computes when it starts, and what at every instant.

    A signal is static if it depends on the node's statics and on constants only, through operations
    and functions. It never changes, so one that costs something (a call of a function or of the C
    library, anywhere in its computation) is computed by the reset and kept in the state, if the
    step reads it. A cheap one is computed where it is read: that costs less than memory. The levels
    of the source language promise that a [Delay]'s [init] and an instance's [statics] are static.

    A [Function] node has no state, hence no reset: all is done in the step. *)

type t = {
  at_reset : Flow.Schedule.item list;
      (** in order: all that [kept], the initial values of delays and the statics of instances need
      *)
  kept : Flow.Ir.signal list;  (** defined [at_reset], held in the state for the step *)
  in_step : Flow.Schedule.item list;
      (** in order: all that the outputs and the state need, but for [kept]; cheap static items may
          be [at_reset] as well *)
  read_by_step : Flow.Ir.signal list;
      (** those of the node's statics that the step needs as arguments, for itself or for its
          instances *)
}

val program : Flow.Ir.program -> t array
(** For each node. Raises {!Basis.Diagnostic.Bug} if an initial value or an instance's static is not
    static. *)

val equations_in_step : t -> Flow.Ir.equation list
(** Those among the items [in_step]. *)
