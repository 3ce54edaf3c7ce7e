(** Generates a loop over arrays as a [for] with a fixed number of iterations. *)

val statements :
  Expression.names ->
  Step.Ir.loop ->
  call:(string -> Ir.expr list -> Ir.expr list -> Ir.expr) ->
  Ir.statement list
(** The loop, preceded by the declarations of its results. [call] generates the step of an iteration
    from the index, the arguments, and the places for the results if there are several. *)
