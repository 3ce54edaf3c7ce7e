(** Prints Flow for dumps, node by node.

    A signal is printed with the programmer's name. If several signals of a node have the same name,
    the later ones are numbered. Signals without a name are [_1], [_2]…, so the text of a node does
    not depend on the rest of the program. *)

val program : Format.formatter -> Ir.program -> unit
val ty : Ir.sum array -> Ir.ty -> string
val float : float -> string

val operator : Ir.operator -> string
(** The operator in source syntax: [+], [min]. *)
