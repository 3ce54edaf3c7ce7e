(** Applies passes to one node at a time. *)

type pass = fresh:(unit -> int) -> Ir.node -> Ir.node
(** [fresh] returns an id that no signal of the program has. *)

val program : pass -> Ir.program -> Ir.program
(** Returns a program physically equal to its argument if the pass changes no node. *)
