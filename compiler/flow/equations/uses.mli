(** How often something is used. *)

val of_nodes : Ir.program -> int array
(** By node: how many instances run it. *)
