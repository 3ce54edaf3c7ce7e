(** Translates stateful equations: delays, integrals, derivatives, times and ticks, which use the
    fields that {!State} allocates.

    Times and integrals advance at the start of a step, a derivative where its equation is computed,
    and a delay at the end. *)

open Basis

val advance : limited:bool -> State.t -> Flow.Ir.equation -> Ir.statement option
(** The statement that advances a time or integral at the start of a step. If [limited], the node's
    time cannot overflow, so a time that is never reset needs no check (see {!Flow.Time_limit}). *)

val step : fresh:(unit -> int) -> Draft.t -> State.t -> Flow.Ir.equation -> unit
(** Adds the value of an equation, and any state changes that happen where the equation is computed.
    A stateless equation is simply computed. [fresh] returns ids for signals. *)

val next :
  Draft.t ->
  State.t ->
  Flow.Ir.equation ->
  (Ir.field * Flow.Ir.atom * Flow.Ir.signal option * Span.t) option
(** The field to write at the end of the step and its value, in the form of [states] in
    {!Fragment.t}. *)

val reset : Draft.t -> State.t -> Flow.Ir.equation -> Fragment.item list
(** Initializes the memory. *)

val keep : Draft.t -> State.t -> Span.t -> Flow.Ir.signal -> Fragment.item list
(** Makes the reset store a static value in its field, if it has one, for use in the step. *)
