(** Lazy values, which are evaluated when first needed and then cached.

    The parts of tuples and data are thunks, so that a component depends only on the values it is
    computed from. The causality check also treats each component separately. *)

type 'a t

val known : 'a -> 'a t
val delay : (unit -> 'a) -> 'a t

type nesting
(** The current nesting depth of evaluations in one run of a program. *)

val nesting : unit -> nesting

val equation : nesting -> name:string -> (unit -> 'a) -> 'a t
(** Like {!delay}, for values whose evaluation can be abandoned and restarted: equations of the
    current instant, and definitions. Chains of these may have any length: when evaluation nests too
    deeply, {!force} abandons it, and {!demand} evaluates the thunk at which it stopped before
    trying again. *)

val force : 'a t -> 'a
(** The value. May only be called while {!demand} evaluates a thunk. A thunk that needs its own
    value is a loop within one instant. That is a compiler bug, because causality has been checked.
*)

val demand : 'a t -> 'a
(** The value. Must be called outside of any evaluation. *)

val afresh : nesting -> (unit -> 'a) -> 'a
(** Runs a function that calls {!demand} while another evaluation is still in progress. *)
