(** What is known of a node's Bools at an instant. *)

type t

val definitions : Ir.node -> Ir.rhs Basis.Int_table.t
(** Of its Bools. *)

val at_an_instant : Ir.node -> (Ir.signal * bool) list -> t
(** What follows for others from these values. Apply it to the node once, to the values as often as
    wanted. *)

val while_running : Ir.node -> (Ir.signal * bool) list -> t
(** Likewise, of a mode at an instant at which it goes on running: that none of its transitions
    occurs, and what follows from that for their conditions. *)

val value : t -> Ir.atom -> bool option
(** As far as it is known. *)
