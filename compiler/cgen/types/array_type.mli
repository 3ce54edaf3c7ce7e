(** Arrays in C. A struct wraps each array, so that it can be assigned and returned like any other
    value. Also generates the functions on this struct. *)

val name : Flow.Ir.sum array -> Step.Ir.ty -> string
(** An identifier for the type: [float_16], [maybe_float_3_4]. *)

val element : Ir.expr -> Ir.expr -> Ir.expr
(** The expression [a.at[i]]. *)

val definition : string -> count:int -> element:Ir.ty -> Ir.declaration
(** The definition of the struct with this name. *)

type operation =
  | At  (** the element at an index, or a default value if the index is outside the array *)
  | Replace
  | Fill

val operations : operation list
val suffix : operation -> string

val function_ :
  operation -> string -> struct_name:string -> count:int -> element:Ir.ty -> Ir.function_
(** The function with this name that performs the operation. *)
