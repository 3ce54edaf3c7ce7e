(** Evaluates the primitives that are functions on values. *)

type position = Evaluator.position

val apply :
  position -> Node.target -> Core.Primitive.t -> result:Core.Ir.ty -> Value.argument list -> Value.t
(** Applies a primitive to all its arguments, in order. The result type is closed. The primitive
    must not be, or return, a signal function or a program. *)
