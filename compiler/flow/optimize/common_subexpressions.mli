(** Every common subexpression once in each node.

    Two equations are one if their right sides are the same operation on signals that are one; so
    are two instances of a node with the same statics and inputs, as both start together and make
    the same steps. Delays too, but for those that are equal only because they are (two counters
    that were never one instance). The first of each class stays, and with it a name that the
    programmer gave to any of them. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if nothing is computed twice. *)
