(** Passes over one node at a time. *)

type pass = fresh:(unit -> int) -> Ir.node -> Ir.node
(** [fresh] gives an id that no signal of the program has. *)

val program : pass -> Ir.program -> Ir.program
(** The same program, physically, if each node stays the same, physically. *)
