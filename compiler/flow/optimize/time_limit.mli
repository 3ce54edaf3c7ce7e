(** Local times that end, or start again, long before they could come to the end of time.

    [after 2[s]] ends the mode: so its time is below 2 s at each instant that it
    goes on from, and however long the next takes, the sum needs no check. Likewise
    where a time has come to its limit and so starts again an instant later, as in
    [debounce]. *)

val is_limited : Ir.program -> int -> Ir.atom -> bool
(** Of a node's time with that [restart] (see {!Ir.rhs}): that it ends or starts again
    at the latest at half the time there is. False if a machine around it has instants of
    its own, between which any time may pass. *)
