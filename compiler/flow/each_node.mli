(** Passes over one node at a time.

    Several such passes are best done on one node after the other: it is in the
    processor's cache then, and what one makes for the next is soon thrown away. *)

type pass = fresh:(unit -> int) -> Ir.node -> Ir.node
(** [fresh] gives an id that no signal of the program has. *)

val program : pass -> Ir.program -> Ir.program
(** The same program, physically, if each node stays the same, physically. *)
