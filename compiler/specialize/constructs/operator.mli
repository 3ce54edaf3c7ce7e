(** The operator's console: what a program asks of it, and where that stands in its input.

    A program is specialized twice if it asks for something. The first time everything on the
    console is unknown, and what is asked for is noted; the second time the type [Console] has a
    field for each. *)

val apply :
  Evaluator.position ->
  Core.Primitive.console ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** On all arguments. Emits E0440 for a label, E0441 for a knob's limits, E0442 for two things under
    one label. *)

val is_looked_for : Context.t -> Core.Ir.expr -> bool
(** Of a function's body: it asks for something itself, and what is asked for is being found out.
    Then it is evaluated wherever it is called, for each place counts. *)

val at_rest : Context.t -> Value.t
(** The console that nobody touches. *)
