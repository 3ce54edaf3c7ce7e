(** Modes in which a machine only waits for its user to end disappear.

    A task that is over puts out literals, one of them that it is over; a mode that runs
    it as a part of itself ends at that very instant, and its state is dropped. So the
    mode before need not hand over to one that says so: it says so itself, and goes on,
    for nobody sees what it keeps of that instant. What else it puts out then is dropped
    by its user too; where it is not, the mode stays. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there was no such mode. What nothing leads to any
    more is left to {!Unreachable}. *)
