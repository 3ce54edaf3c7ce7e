(** The primitives on arrays.

    What Flow can hold becomes a {!Loop}; an array of functions or signal functions has been written
    out, so there each element is treated for itself. So are the elements of a short array that is
    written out. *)

val apply :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  Core.Primitive.t ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** All its arguments. The evaluator is one for the nodes of rounds. *)

val parallel :
  Evaluator.position ->
  Evaluator.t ->
  result:Core.Ir.ty ->
  Value.argument ->
  Value.argument ->
  Value.t
(** Of an array of signal functions, each run on an element of the second. *)

val map_sf :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  result:Core.Ir.ty ->
  Value.argument ->
  Value.argument ->
  Value.t
(** The signal function, and the array that is its input. *)
