(** Ensures that dt is 0 in the first instant wherever this can be observed.

    An expression that reads dt observes it. An integral does not, because its previous input is 0
    in the first instant. A node also observes dt if, in the first instant, it steps a node that
    observes dt. Only the possible initial modes of a machine can take a step with this dt; modes
    that follow them in the same instant are always entered with a dt of 0. *)

val program : Ir.program -> Ir.program
(** If dt can be observed, adds the {!Ir.mark} of the root's first step to the program. The mark is
    a delay that the program already contains or, if there is none, a new field. *)
