(** Common subexpression elimination within each node.

    Merges two equations if their right-hand sides apply the same operation to equal signals. Also
    merges two instances of a node with the same static parameters and inputs, because they start
    together and take the same steps. Delays are merged, too, except for those that are equal only
    if they are assumed to be (such as two counters that were never one instance). The first
    equation of each class remains, and inherits the programmer's name from any of them. *)

val program : Ir.program -> Ir.program
(** Returns the same program, physically, if nothing is computed twice. *)
