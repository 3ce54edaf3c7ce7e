(** The names and the numbers of arguments of the primitives. *)

val of_name : string -> Primitive.t option
(** Finds a primitive by the name declared in the library. *)

val name : Primitive.t -> string

val key : Primitive.t -> string
(** A key that is unique for each primitive. The name is not unique, because a foreign primitive may
    have the same name as another one. *)

val arity : Primitive.t -> int
