(** Specializes a robot-independent program or signal function to the types of a robot. *)

val program :
  Ir.program ->
  Ir.definition ->
  suffix:string ->
  input:Ir.ty ->
  output:Ir.ty ->
  Ir.program * Ir.Global.t
(** Adds a definition that specializes the given one (of type [Program i o] or [SF i o]) to these
    types. Its name is the name of the given definition, followed by the suffix. *)
