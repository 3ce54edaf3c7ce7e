(** Finds choices whose condition depends on their own result in earlier steps.

    The condition depends, through delays and integrals, on the value that was chosen in the
    previous instant; examples are the anti-windup of a controller, and a counter that starts again.
    If such a choice were compiled to a select, each step would have to wait for the condition of
    the previous step. If it is compiled to a branch, the processor predicts the branch, so that
    consecutive steps overlap. *)

type t

val none : t

val of_node : Flow.Ir.node -> t
(** Takes time linear in the size of the node. *)

val mem : t -> Flow.Ir.signal -> bool
(** Whether a choice whose condition depends on its own result defines the signal. *)
