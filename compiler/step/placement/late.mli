(** Results that are read from the state when it has been written.

    A signal that keeps its value until something happens, as [hold] makes it, is the next value of
    a delay: [y = if c then x else before] with [before = delay x0 y]. When the state has been
    written, [y] is what the delay's field holds. If all else that uses [y] is results, these are
    read from there, and the choice needs no variable:

    {v
    if (c) {
        self->before = x;
    }
    out->y = self->before;
    v} *)

val split : Fragment.t -> (Fragment.t * Fragment.t) option
(** What is to be done first, and what is read from the state after that; [None] if there is nothing
    of the kind. *)
