(** The meaning of the primitives that are functions of values. *)

exception Foreign_code of string
(** That function of the user's C would have to run. *)

val apply : Basis.Real.t -> Core.Primitive.t -> Value.thunk list -> Value.t
(** In the precision of the program; with all its arguments, as many as its arity says. [&&] and
    [||] look at their second argument only if the first does not decide. *)
