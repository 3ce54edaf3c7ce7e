(** Drawing: the primitives of the library's module Display.

    A drawing consists of a count of marks and an array of events. The first [count] events occur.
    If the array has room for all marks that can be drawn ({!Flow.Marks}), no mark is lost. An array
    of one element is enough to compute how many marks can be drawn. If drawing is disabled
    ({!Context.options}), drawings have no leaves. *)

val apply :
  Evaluator.position ->
  Node.target ->
  Core.Primitive.t ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
