(** The primitives on arrays.

    What Flow can hold becomes a {!Loop}; an array of functions or signal
    functions has been written out, so there each element is treated for
    itself. So are the elements of a short array that is written out. *)

open Basis

(** Evaluation in the node of one round. *)
type evaluator = {
  apply :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:Core.Ir.ty ->
    Value.t ->
    Value.argument list ->
    Value.t;
  run :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:Core.Ir.ty ->
    Value.t ->
    Value.argument ->
    Value.t;
}

val apply :
  Comparison.position ->
  evaluator ->
  Node.target ->
  Core.Primitive.t ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** All its arguments. *)

val map_sf :
  Comparison.position ->
  evaluator ->
  Node.target ->
  result:Core.Ir.ty ->
  Value.argument ->
  Value.argument ->
  Value.t
(** The signal function, and the array that is its input. *)
