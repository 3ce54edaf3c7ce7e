(** Replaces delays that are constant while their mode runs.

    For example, [after] stores whether it has occurred, so that it occurs only once. If the mode
    ends when it occurs, this value is never read. A [delay] of Bools with the initial value b is
    replaced by b if it keeps this value as long as no transition of the mode occurs. The value
    could change only in the last instant of the mode. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there is no such delay. *)
