(** NAME_is_valid: whether a state is one that a step can leave behind. It checks the number of each
    running mode: if memory was damaged, the step would otherwise run some mode without notice.
    Because it is a function of its own, the step takes no longer, and who does not call it does not
    pay for it. *)

val functions : Program_names.t -> Ir.function_ list
(** The function of the root, which hosts call, after the functions of the nodes that it calls.
    Empty if no machine has more than one mode. *)
