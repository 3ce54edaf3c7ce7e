(** The code of what equations remember: delays, integrals, derivatives, times and ticks, each in
    the fields that {!State} has for it.

    Times and integrals advance at the start of a step, a derivative where it stands, and a delay at
    the end. *)

open Basis

val advance : limited:bool -> State.t -> Flow.Ir.equation -> Ir.statement option
(** At the start of a step, before anything is computed. [limited]: the node's time, if it never
    starts again, needs no check (see {!Flow.Time_limit}). *)

val step : fresh:(unit -> int) -> Draft.t -> State.t -> Flow.Ir.equation -> unit
(** The equation's value, and what changes where it stands; one without memory is computed. [fresh]
    gives ids for signals. *)

val next :
  Draft.t ->
  State.t ->
  Flow.Ir.equation ->
  (Ir.field * Flow.Ir.atom * Flow.Ir.signal option * Span.t) option
(** The state to write at the end of the step, as in {!Fragment.t}. *)

val reset : Draft.t -> State.t -> Flow.Ir.equation -> Fragment.item list
(** What the memory starts with. *)

val keep : Draft.t -> State.t -> Span.t -> Flow.Ir.signal -> Fragment.item list
(** In the reset: a static value is kept for the step, if it has a field. *)
