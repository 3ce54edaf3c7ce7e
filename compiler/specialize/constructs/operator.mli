(** The operator's console: the controls that a program requests, and their positions in its input.

    A program that requests controls is specialized twice. The first time, all controls have unknown
    values, and the requests are recorded. The second time, the type [Console] has a field for each
    control. *)

val apply :
  Evaluator.position ->
  Core.Primitive.console ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** Evaluates a control with all its arguments. Emits E0440 for an invalid label, E0441 for invalid
    limits of a knob, and E0442 for two different controls with the same label. *)

val is_looked_for : Context.t -> Core.Ir.expr -> bool
(** Whether requests are being recorded and the function's own body requests a control. If so, the
    body must be evaluated at each call, because each place that calls the function counts as a
    separate request. *)

val at_rest : Context.t -> Value.t
(** The console with all controls in their initial positions. *)
