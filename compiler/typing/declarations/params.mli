(** Checks that the parameters of a program have types whose values can be written on a command
    line. *)

val program :
  report:(Declaration_fact.t -> unit) -> Resolve.Ir.program -> Ir.definition list -> Ir.param list
(** Reports a type that is neither a number nor a Bool, or that is polymorphic. *)
