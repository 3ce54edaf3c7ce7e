(** The array primitives.

    Operations on values that Flow can represent become a {!Loop}. An array of functions or signal
    functions has no run-time form, so the operation is expanded for each of its elements. The same
    happens for a short array literal. *)

val apply :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  Core.Primitive.t ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** Applies a primitive to all its arguments. The evaluator must be the variant for loops, which
    evaluates functions in the node of the iteration. *)

val parallel :
  Evaluator.position ->
  Evaluator.t ->
  result:Core.Ir.ty ->
  Value.argument ->
  Value.argument ->
  Value.t
(** Runs each signal function of the first array on the corresponding element of the second. *)

val map_sf :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  result:Core.Ir.ty ->
  Value.argument ->
  Value.argument ->
  Value.t
(** Runs the signal function on each element of the input array. *)
