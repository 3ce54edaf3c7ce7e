(** What helps where an event stands in the place of something else, or the reverse: hints for
    {!Shape_mistake}. *)

val hint :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  found:Type.t ->
  string option
