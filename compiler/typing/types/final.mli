(** Types as inference leaves them: to be asked for only when everything that can be found has been.
    What nothing decided gets its default: [()] for a type, [Float] for a representation, [1] for a
    unit.

    During inference a type may stand in another many times at no cost; written out it grows with
    each time, to twice its size with each [pair (pair …)]. So there is a limit to it, for the sake
    of everything that comes after. *)

exception Too_large

val most_parts : int

val deepest : int
(** How deep types may nest, the arguments of a function beside each other. *)

val ty : Type.t -> Ir.ty
(** Work is shared between calls: linear in the types of a definition, however often they occur.

    @raise Too_large beyond either limit, which also ends the work soon *)

val representation : Type.representation -> Ir.representation

val scheme : Type.scheme -> Ir.scheme
(** @raise Too_large as {!ty} does. *)
