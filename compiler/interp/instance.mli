(** Class instances: finds the definition of a method at a type. *)

type table

val table : Core.Ir.instance list -> table

val method_ :
  table ->
  class_:Core.Ir.Global.t ->
  name:string ->
  Core.Ir.ty ->
  (Core.Ir.Global.t * Core.Ir.ty list) option
(** The definition of the method for a type without variables, and the types that replace the first
    type parameters of that definition. *)
