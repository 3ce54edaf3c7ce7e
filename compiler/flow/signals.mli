(** The signals that a program defines. *)

val iter : (Ir.signal -> unit) -> Ir.node -> unit
(** Each once: statics, inputs, equations, outputs of instances and of the
    machine. *)

val next_id : Ir.program -> int
(** Larger than every id and group. Ids are given one after the other, so a
    table by id may be an array of this size. *)
