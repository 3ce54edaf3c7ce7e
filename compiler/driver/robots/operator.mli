(** What a program asks of its operator, for its table and the report. *)

val declared :
  Specialize.Context.options ->
  Basis.Diagnostic.sink ->
  Typing.Ir.program ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Core.Ir.program option
(** With a field of the type [Console] for each thing that the entry asks for, and knobs with their
    units. Emits E0440, E0441, E0442; [None] if errors were reported. *)
