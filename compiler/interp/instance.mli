(** The instances of classes: which definition a method is at a type. *)

type table

val table : Core.Ir.instance list -> table

val method_ :
  table ->
  class_:Core.Ir.Global.t ->
  name:string ->
  Core.Ir.ty ->
  (Core.Ir.Global.t * Core.Ir.ty list) option
(** The definition for a type without variables, and the types for the first of its parameters. *)
