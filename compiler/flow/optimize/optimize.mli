(** The passes over a causal Flow program, in one table with the reason for the position of each.

    Every output stays the same, bit for bit. Afterwards every instance can run as one call
    ({!Schedule.of_node} succeeds on every node), no equation is a [Copy], and every signal is
    needed. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** Calls [after] with each pass and its result. *)
