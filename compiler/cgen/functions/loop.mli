(** A loop over arrays as a bounded [for]. *)

val statements :
  Expression.names ->
  Step.Ir.loop ->
  call:(string -> Ir.expr list -> Ir.expr list -> Ir.expr) ->
  Ir.statement list
(** With the declarations of its results before it. [call] is the step of a round, given the index,
    the arguments, and the places for more than one result. *)
