(** The passes over a causal flow program, in one table: each with the reason for its place.

    Every output stays the same, bit for bit. Afterwards every instance can run as one call
    ({!Schedule.of_node} succeeds on every node), no equation is a [Copy] and every signal is
    needed. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] is told of each pass and of the program that it has made. *)
