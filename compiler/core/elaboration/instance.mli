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
(** The definition of a method for a type, and its type arguments, given the arguments for the
    method's own parameters. [None] for a type variable. *)
