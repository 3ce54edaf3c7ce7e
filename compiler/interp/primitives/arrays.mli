(** The primitives on arrays (language reference, section 4). *)

val apply :
  (Value.t -> Value.thunk list -> Value.t) ->
  Core.Primitive.t ->
  size:int ->
  Value.thunk list ->
  Value.t option
(** Applies a primitive to all its arguments. The first parameter applies a function to arguments;
    [size] is the size of the resulting array, if its type determines it. Returns [None] for
    primitives that do not operate on arrays. *)

val map_sf : size:int -> Value.thunk -> Value.instance
val parallel : Value.thunk -> Value.instance

val element : Value.t -> int -> Value.t
(** The element [a ! k]. *)
