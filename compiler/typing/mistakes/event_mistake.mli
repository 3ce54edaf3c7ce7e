(** What helps where an event stands in the place of something else, or the reverse: hints for
    {!Shape_mistake}. *)

val accumulated :
  Show.words ->
  name:string ->
  at:Basis.Span.t ->
  (Resolve.Ir.expr * Type.t) list ->
  Basis.Diagnostic.t ->
  Basis.Diagnostic.t
(** [accumHold x0 f e], as other languages have it, with the types of the arguments: what is said of
    it instead. *)

val hint :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  found:Type.t ->
  string option
