(** Types as inference leaves them: to be asked for only when everything that
    can be found has been. What nothing decided gets its default: [()] for a
    type, [Float] for a representation, [1] for a unit. *)

val ty : Type.t -> Ir.ty
(** Work is shared between calls: linear in the types of a definition, however
    often they occur. *)

val representation : Type.representation -> Ir.representation
val scheme : Type.scheme -> Ir.scheme
