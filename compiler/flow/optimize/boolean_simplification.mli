(** Conditions that say in a roundabout way what one or two others say: [a], [not a], [a && b] or
    [a || b].

    [mergeE] makes a choice of three cases where only whether one of two events occurs is wanted in
    the end. What is found is tried out, with all values of the two. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there is no such condition. *)
