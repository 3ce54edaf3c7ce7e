(** Code in C: a node without a body for each function or signal function that is imported, called
    like any other. *)

val apply :
  Evaluator.position ->
  Node.target ->
  Core.Primitive.foreign ->
  result:Core.Ir.ty ->
  Value.argument list ->
  Value.t
(** On all arguments; of a signal function, an instance on its input. *)

val imports : Types.table -> Core.Ir.foreign -> Flow.Ir.import list

val check_names : Basis.Diagnostic.sink -> name:string -> Core.Ir.foreign -> unit
(** [name]: of the program's C files. Emits E0431 where the program's own C has the names of what it
    imports. *)
