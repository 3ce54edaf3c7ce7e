(** Infers records: construction, field access and update.

    The type of [e] determines which record [e.f] belongs to. While that type is unknown, the
    decision is postponed, at most until the end of the top-level group. If the type is still
    unknown then, and only one type in scope has the field, that type is chosen. *)

open Context

val construct :
  expressions ->
  t ->
  ?wanted:Type.t ->
  Resolve.Ir.expr ->
  Ir.Global.t ->
  (Syntax.Ir.name * Resolve.Ir.expr) list ->
  typed
(** [wanted]: the expected type, whose type constructor must be that of the record. It determines
    the expected field types. The caller compares the resulting type with [wanted]. *)

val field :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  record:Resolve.Ir.expr ->
  Syntax.Ir.name ->
  candidates:Ir.Global.t list ->
  typed

val update :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  record:Resolve.Ir.expr ->
  (Syntax.Ir.name * Resolve.Ir.expr) list ->
  candidates:Ir.Global.t list ->
  typed
