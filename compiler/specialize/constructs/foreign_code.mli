(** Foreign code: each imported function or signal function is a node without a body, called like
    any other node. *)

val apply :
  Evaluator.position ->
  Node.target ->
  Core.Primitive.foreign ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** Applies a function to all its arguments, or runs an instance of a signal function on its input.
*)

val imports : Context.t -> Flow.Ir.import list
(** The foreign functions that the program's own modules import, and those that the library imports
    and a node of the program calls. *)

val check_names : Context.t -> name:string -> unit
(** [name]: the name of the generated C files. Reports names that the program imports and that the
    generated C would also define. *)
