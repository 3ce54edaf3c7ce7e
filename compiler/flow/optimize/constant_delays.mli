(** Delays of modes that show one value for as long as their mode runs.

    [after] notes that it has occurred, so as to occur once; in a mode that ends there nobody ever
    reads the note. A Bool's [delay] that starts with b is b, if at an instant at which it is b and
    no transition of the mode occurs its next value is b again: the first instant at which it would
    be another one is the mode's last. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if it has no such delay. *)
