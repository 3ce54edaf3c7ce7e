(** Places in the structs of an {!Interface}. *)

val path : Ir.expr -> Interface.step list -> Ir.expr list -> Ir.expr
(** The place that the steps lead to from a pointer to the struct, at these indices of the arrays
    around it. *)

val for_each :
  Expression.names ->
  Interface.step list ->
  (Ir.expr list -> Ir.statement list) ->
  Ir.statement list
(** Gets the indices of all arrays around the place. *)

val dimensions : Interface.step list -> int

val clear : Expression.names -> Interface.step list -> Ir.expr -> Ir.statement list
(** The place becomes 0, in all elements of the arrays around it. *)

val copy :
  Expression.names ->
  Interface.step list ->
  from_interface:bool ->
  Ir.expr ->
  Ir.expr ->
  Ir.statement
(** Between a place in arrays of the struct and a variable of an array type. *)
