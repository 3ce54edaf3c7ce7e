(** Finds modes that end long before their local time could overflow.

    For example, [after 2[s]] ends the mode. The mode's time is therefore below 2 s whenever the
    mode continues, and adding any dt to it cannot overflow. *)

val is_limited : Ir.program -> int -> bool
(** Whether this node is a mode whose local time never restarts, and that ends, at the latest, when
    this time reaches half of its maximum. False if the node is inside a machine that does not run
    in every instant, because any amount of time may pass between its instants. *)
