(** Finds choices whose condition depends on their own result in earlier steps.

    The condition is computed from the value that was chosen in the previous instant, through delays
    and integrals; examples are the anti-windup of a controller, and a counter that starts again. If
    the choice were a select, each step would wait for the condition of the previous one. A branch
    is predicted, so the steps overlap. *)

type t

val none : t

val of_node : Flow.Ir.node -> t
(** Linear in the size of the node. *)

val mem : t -> Flow.Ir.signal -> bool
(** Whether such a choice defines the signal. *)
