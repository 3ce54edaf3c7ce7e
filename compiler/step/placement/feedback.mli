(** Which choices decide about themselves from one step to the next.

    The condition of such a choice is computed, perhaps through delays and integrals, from the value
    that it chose an instant ago: the anti-windup of a controller, a counter that starts again. As a
    select the value would have each step wait until the condition of the step before is known; a
    branch is predicted, and the steps overlap. *)

type t

val none : t

val of_node : Flow.Ir.node -> t
(** Linear in the size of the node. *)

val mem : t -> Flow.Ir.signal -> bool
(** Is the signal defined by such a choice? *)
