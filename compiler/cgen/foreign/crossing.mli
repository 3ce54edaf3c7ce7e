(** Passes values to the user's C and back.

    The user's C uses doubles, regardless of the program's precision. In double precision, values
    are passed unchanged. In single precision, each number in a value is cast: a float is widened to
    a double, and a double is rounded to a float. *)

type direction = To_c | From_c

val is_converted : Expression.names -> Step.Ir.ty -> bool

val number : Expression.names -> direction -> Step.Ir.ty -> Ir.expr -> Ir.expr
(** Converts a single number. Returns the value unchanged if it needs no conversion. *)

val assign :
  Expression.names -> direction -> Step.Ir.ty -> to_:Ir.expr -> from:Ir.expr -> Ir.statement list
(** Assigns any value except an array. *)

val elements :
  Expression.names ->
  direction ->
  Step.Ir.ty ->
  Interface.step list ->
  c:(Ir.expr list -> Ir.expr) ->
  own:Ir.expr ->
  Ir.statement list
(** Assigns a value that may be an array. [own] is the program's value. [c] returns the place in the
    user's C, given an index for each array on the path. *)
