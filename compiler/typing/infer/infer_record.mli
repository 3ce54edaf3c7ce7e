(** Records: construction, fields and updates.

    Which record [e.f] belongs to is decided by the type of [e], at the latest at the end of the
    top-level group; if it is still unknown then and only one type in scope has the field, it is
    that one. Codes: [E0310] no such field · [E0311] the record's type is unknown. *)

open Context

val construct :
  expressions ->
  t ->
  ?wanted:Type.t ->
  Resolve.Ir.expr ->
  Ir.Global.t ->
  (Syntax.Ir.name * Resolve.Ir.expr) list ->
  typed
(** [wanted] is a type of the constructor's type constructor: fields are checked against what they
    are in it. The caller compares the result with it. *)

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
