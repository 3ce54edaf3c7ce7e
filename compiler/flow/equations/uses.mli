(** How often something is used. *)

val of_nodes : Ir.program -> int array
(** By node: how many instances run it. *)

val of_signals : Ir.node -> Ir.signal -> int
(** How often a node reads a signal, its outputs included. *)
