(** Local times that end long before they could come to the end of time.

    [after 2[s]] ends the mode: so its time is below 2 s at each instant that it goes on from, and
    however long the next takes, the sum needs no check. *)

val is_limited : Ir.program -> int -> bool
(** Of a node's time that never starts again: that the node, a mode, ends at the latest at half the
    time there is. False if a machine around it has instants of its own, between which any time may
    pass. *)
