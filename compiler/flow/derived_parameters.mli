(** What a mode needs only of parameters that it computes something of is computed before,
    and passed in their place.

    A mode that is entered with the place where the one before began, and needs no more of
    it than its distance from a goal, is entered with that distance: one number is handed
    on from mode to mode, and kept, not two. And where the distance is computed anyhow for
    the transitions of the mode that hands it on, it is computed no more than there.

    So it is done where each transition into the mode passes parameters of its own mode,
    which that one reads for nothing else, and there are two at least; or something of
    which the result is there anyhow; or literals. Parameters that are always literals are
    left to {!Literal_parameters}. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there was nothing to replace. It leaves equations
    that nothing reads. *)
