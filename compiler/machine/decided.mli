(** What a condition decides is written where the condition is asked.

    [self->waiting = differs & !settled] after an [if (settled)] goes into its branches, as
    far as what it reads allows: in one it is a constant, in the other it is simpler.

    {v
    if (settled) {
        self->before = in->button;
        self->waiting = false;
    } else {
        self->waiting = differs;
    }
    v} *)

val statements : Ir.statement list -> Ir.statement list
