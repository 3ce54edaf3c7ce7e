(** The passes over a causal flow program, in a good order.

    Every output stays the same, bit for bit. Afterwards every instance can
    run as one call ({!Schedule.of_node} succeeds on every node), no equation
    is a [Copy] and every signal is needed. *)

val program : Ir.program -> Ir.program
