(** Finds class instances by type constructor. *)

type table

val table : Ir.instance list -> table

val find :
  table ->
  class_:Ir.Global.t ->
  name:string ->
  Ir.ty ->
  Ir.ty list ->
  (Ir.Global.t * Ir.ty list) option
(** Returns the definition of a method for the given type, with all the type arguments of that
    definition. The last argument contains the type arguments for the method's own parameters.
    Returns [None] for a type variable. *)
