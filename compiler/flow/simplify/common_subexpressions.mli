(** Common subexpression elimination within each node.

    Merges two equations if their right-hand sides apply the same operation to equal signals. Also
    merges two instances of a node with the same static parameters and inputs, because they start
    together and take the same steps. Also merges delays, except those whose equality can only be
    proved by assuming it (such as two counters that are not instances of one node). An absolute
    value and a distance ([hypot]) do not depend on the sign of their operands, so [abs (a - b)] and
    [abs (b - a)] are merged, for example. The first equation of each class remains, and inherits a
    programmer's name from any equation of the class. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if nothing is computed twice. *)
