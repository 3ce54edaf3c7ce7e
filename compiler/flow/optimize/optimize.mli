(** The optimization passes over a causal Flow program. One table lists them, with the reason for
    the position of each pass.

    Every output stays the same, bit for bit. Afterwards every instance can run as one call
    ({!Schedule.of_node} succeeds on every node), no equation is a [Copy], and every signal is
    needed. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** Calls [after] with each pass and its result. *)
