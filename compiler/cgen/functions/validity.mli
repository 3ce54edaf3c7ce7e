(** Generates the function NAME_is_valid, which checks whether a step can leave the given state
    behind. It checks the number of each running mode: if memory was damaged, the step would
    otherwise run some mode without notice. It is a separate function, so the step does not become
    slower, and callers decide whether to pay for the check. *)

val functions : Program_names.t -> Ir.function_ list
(** The function of the root, which hosts call. It follows the functions of the nodes that it calls.
    Empty if no machine has more than one mode. *)
