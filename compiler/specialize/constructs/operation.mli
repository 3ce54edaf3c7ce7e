(** The meaning of the primitives that are functions of values. *)

type position = Evaluator.position

val apply :
  position -> Node.target -> Core.Primitive.t -> result:Core.Ir.ty -> Value.argument list -> Value.t
(** A primitive with all its arguments, in order; the type is closed. Not for primitives that are or
    make signal functions or programs. *)
