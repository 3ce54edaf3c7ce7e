(** The signals that a program defines. *)

val iter : (Ir.signal -> unit) -> Ir.node -> unit
(** Each once: statics, inputs, equations, outputs of instances and of the machine. *)

val next_id : Ir.node array -> int
(** The least number larger than every id and group: at most what the program says. *)
