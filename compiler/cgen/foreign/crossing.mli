(** Values on their way to the user's C and back.

    C has doubles whatever a program computes with. In double precision a value goes over as it is.
    In single precision its numbers are converted one by one, each with a cast: any float is a
    double, and a double is rounded. *)

type direction = To_c | From_c

val is_converted : Expression.names -> Step.Ir.ty -> bool

val number : Expression.names -> direction -> Step.Ir.ty -> Ir.expr -> Ir.expr
(** A value in one piece: a number, or what is not converted. *)

val assign :
  Expression.names -> direction -> Step.Ir.ty -> to_:Ir.expr -> from:Ir.expr -> Ir.statement list
(** Any value but an array. *)

val elements :
  Expression.names ->
  direction ->
  Step.Ir.ty ->
  Interface.step list ->
  c:(Ir.expr list -> Ir.expr) ->
  own:Ir.expr ->
  Ir.statement list
(** A value that may be an array: on C's side the steps lead to it, and [c] gives the place at the
    indices of the arrays on the way; [own] is the program's. *)
