(** Facts about the Bools of a node in one instant. *)

type t

val definitions : Ir.node -> Ir.rhs Basis.Int_table.t
(** The definitions of the node's Bools. *)

val at_an_instant : Ir.node -> (Ir.signal * bool) list -> t
(** Derives the consequences of these values. Apply this function to the node first; the result can
    then be applied to values any number of times. *)

val while_running : Ir.node -> (Ir.signal * bool) list -> t
(** Like {!at_an_instant}, for an instant in which a mode continues to run, so none of its
    transitions occurs. *)

val at_first_instant : Ir.node -> t
(** Derives the values in the node's first instant from the initial values of delays, and from the
    fact that no time has passed. *)

val value : t -> Ir.atom -> bool option
(** The value of an atom, if it is known. *)
