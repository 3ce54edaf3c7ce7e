(** The passes over a causal flow program, in one table: each with the reason for its place.

    Every output stays the same, bit for bit. Afterwards every instance can run as one call
    ({!Schedule.of_node} succeeds on every node), no equation is a [Copy] and every signal is
    needed. *)

type pass = {
  name : string;
  pass : Ir.program -> Ir.program;
  reason : string;  (** of its place among the others *)
}

val program : ?after:(pass -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] is told of each pass and of the program that it has made. *)
