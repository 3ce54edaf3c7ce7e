(** Finds the controls that a program's console needs, for the host's table and the report. *)

val declared :
  Specialize.Context.options ->
  Basis.Diagnostic.sink ->
  Typing.Ir.program ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Core.Ir.program option
(** Adds a field to the type [Console] for each control that the entry requests, and sets the units
    of knobs. Reports E0440, E0441 and E0442; [None] after an error. *)
