(** Instantiates a robot-independent program or signal function with the types of a robot. *)

val program :
  Ir.program ->
  Ir.definition ->
  suffix:string ->
  input:Ir.ty ->
  output:Ir.ty ->
  Ir.program * Ir.Global.t
(** Adds a definition that applies the open one (of type [Program i o] or [SF i o]) at these types,
    where it is open. Its name is that of the open one with the suffix. *)
