(** Of what a function is even in, the sign does not matter.

    [abs], [cos] and [hypot] give the same, bit for bit, for a number and its negation (of
    a NaN they make a NaN). So what is negated there is taken as it was; and of [a - b] and
    [b - a], which differ in their sign alone, one will do for both. A distance from the
    robot to a place and one from the place to the robot are then the same equation, which
    {!Share} keeps once. *)

val node : Ir.node -> Ir.node
val program : Ir.program -> Ir.program
(** The same program, physically, if there was nothing to replace. *)
