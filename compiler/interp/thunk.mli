(** Values on demand: evaluated when first needed, then remembered.

    Tuples and data hold their parts so, which makes a component need only what it is made of:
    causality is judged in the same way, leaf by leaf. *)

type 'a t

val known : 'a -> 'a t
val delay : (unit -> 'a) -> 'a t

type nesting
(** How deeply evaluations nest at the moment, in one run of a program. *)

val nesting : unit -> nesting

val equation : nesting -> name:string -> (unit -> 'a) -> 'a t
(** Like {!delay}, for what can be found again after evaluation was abandoned: an equation of this
    instant, a definition. A chain of these may have any length: when evaluation nests deeply
    {!force} abandons it, and {!demand} evaluates what it had come to first. *)

val force : 'a t -> 'a
(** The value. Only within {!demand}, from one thunk to another. Evaluation that comes back to
    itself is a loop within one instant: a bug, since causality was checked. *)

val demand : 'a t -> 'a
(** The value, from outside all evaluation. *)

val afresh : nesting -> (unit -> 'a) -> 'a
(** Something that calls {!demand}, within evaluation. *)
