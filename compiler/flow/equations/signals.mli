(** The signals that a program defines. *)

val iter : (Ir.signal -> unit) -> Ir.node -> unit
(** Visits each signal once: static parameters, inputs, equations, and outputs of instances and of
    the machine. *)

val next_id : Ir.node array -> int
(** The smallest number larger than every id and group. The program's own [next_id] is at least that
    large. *)
