(** The primitives on arrays, as the language reference has them (section 4). *)

val apply :
  (Value.t -> Value.thunk list -> Value.t) ->
  Core.Primitive.t ->
  size:int ->
  Value.thunk list ->
  Value.t option
(** All its arguments, given how to apply a function; [size] is that of an array that has it from
    its type. [None] for other primitives. *)

val map_sf : size:int -> Value.thunk -> Value.instance
val parallel : Value.thunk -> Value.instance

val element : Value.t -> int -> Value.t
(** [a ! k] *)
