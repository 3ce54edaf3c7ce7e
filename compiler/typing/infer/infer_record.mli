(** Infers records: construction, field access and update.

    The type of [e] determines which record [e.f] belongs to, at the latest at the end of the
    top-level group. If the type of [e] is unknown even then, and only one type in scope has the
    field, that type is chosen. Codes: [E0310] no such field · [E0311] the record's type is unknown.
*)

open Context

val is_of_arrays : t -> Syntax.Ir.name -> bool
(** Is there a function of that name that takes an array? *)

val path : t -> Type.t -> string -> string option
(** The field of this name in a value of the type, or in a record that is one of its fields. *)

val construct :
  expressions ->
  t ->
  ?wanted:Type.t ->
  Resolve.Ir.expr ->
  Ir.Global.t ->
  (Syntax.Ir.name * Resolve.Ir.expr) list ->
  typed
(** [wanted]: the expected type, an application of the constructor's type constructor. It determines
    the expected field types. The caller compares the resulting type with it. *)

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
