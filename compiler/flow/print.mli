(** Flow as text, for dumps: the nodes in their order.

    A signal is shown by the programmer's name; of several with one name in a node the later ones
    get a number, and what has no name is [_1], [_2]…, so that the text does not depend on the rest
    of the program. *)

val program : Format.formatter -> Ir.program -> unit
val ty : Ir.sum array -> Ir.ty -> string
val float : float -> string

val operator : Ir.operator -> string
(** As the source language has it: [+], [min]. *)
