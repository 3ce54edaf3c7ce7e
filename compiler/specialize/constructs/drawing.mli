(** What a program draws: the primitives of the library's module Display.

    A drawing is a number of marks and an array of events; the first so many of these occur. With as
    many elements as marks can be drawn ({!Flow.Marks}) none is lost; with one it is still seen how
    many there can be. Without any ({!Context.options}) all that is drawn has no leaves. *)

val apply :
  Evaluator.position ->
  Node.target ->
  Core.Primitive.t ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
