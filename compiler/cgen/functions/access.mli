(** Accesses places in the structs of an {!Interface}. *)

val path : Ir.expr -> Interface.step list -> Ir.expr list -> Ir.expr
(** The place reached along a path from a pointer to the struct, given an index for each array on
    the path. *)

val for_each :
  Expression.names ->
  Interface.step list ->
  (Ir.expr list -> Ir.statement list) ->
  Ir.statement list
(** Generates nested loops over all enclosing arrays. The given function generates the body from the
    loop indices. *)

val clear : Expression.names -> Interface.step list -> Ir.expr -> Ir.statement list
(** Sets the place to 0 in every element of the enclosing arrays. *)

val copy :
  Expression.names ->
  Interface.step list ->
  from_interface:bool ->
  Ir.expr ->
  Ir.expr ->
  Ir.statement
(** Copies between an array in the struct and a variable of array type. *)
