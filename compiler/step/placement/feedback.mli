(** Finds choices whose condition depends on their own result in earlier steps.

    The condition depends, through delays and integrals, on the value that was chosen in the
    previous instant; examples are the anti-windup of a controller and a counter that restarts. If
    such a choice were compiled to a select, each step would have to wait for the condition of the
    previous step. If it is compiled to a branch, the processor predicts the branch, so that
    consecutive steps can overlap. *)

type t

val none : t

val of_node : Flow.Ir.node -> t
(** Takes time linear in the size of the node. *)

val mem : t -> Flow.Ir.signal -> bool
(** Whether the signal is defined by a choice whose condition depends on the result of that choice.
*)
