(** An open program or signal function, closed by the types of a robot. *)

val program :
  Ir.program ->
  Ir.definition ->
  suffix:string ->
  input:Ir.ty ->
  output:Ir.ty ->
  Ir.program * Ir.Global.t
(** Adds a definition that is the open one (of type [Program i o] or [SF i o]) at these types where
    it is open; its name is the open one's with the suffix. *)
