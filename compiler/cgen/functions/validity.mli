(** Generates the function NAME_is_valid, which checks whether a step could have produced the given
    state. It checks the number of each running mode: if memory was corrupted, the step would
    otherwise silently run some mode. It is a separate function, so the step does not become slower,
    and callers decide whether to pay for the check. *)

val functions : Program_names.t -> Ir.function_ list
(** The root's checking function, which hosts call, preceded by the checking functions of other
    nodes, which it calls. Empty if no machine has more than one mode. *)
