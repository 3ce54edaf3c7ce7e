(** The meaning of the primitives that are pure functions. *)

exception Foreign_code of string
(** Raised when evaluation would have to call this function from the user's C code. *)

val apply : Basis.Real.t -> Core.Primitive.t -> Value.thunk list -> Value.t
(** Applies a primitive to all its arguments, in the given precision. The number of arguments must
    equal the primitive's arity. [&&] and [||] evaluate their second argument only if the first does
    not determine the result. *)
