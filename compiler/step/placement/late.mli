(** Reads results from the state after it has been written.

    A signal that keeps its value until something happens, such as a [hold], is the next value of a
    delay: [y = if c then x else before] with [before = delay x0 y]. After the state has been
    written, the delay's field contains [y]. If all other uses of [y] are results, these are read
    from the field, and the choice needs no variable:

    {v
    if (c) {
        self->before = x;
    }
    out->y = self->before;
    v} *)

val split : Fragment.t -> (Fragment.t * Fragment.t) option
(** Splits a fragment into the part to execute first and the part whose results are read from the
    state afterwards; [None] if no result can be read from the state. *)
