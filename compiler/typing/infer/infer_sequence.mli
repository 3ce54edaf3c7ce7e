(** [do]: tasks, one after the other.

    It becomes applications of {!Environment.sequence}, the rest of the statements being a function
    of what a task ends with. *)

open Context

val check :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  Resolve.Ir.statement list ->
  Resolve.Ir.expr ->
  Expected.t ->
  Ir.expr later
(** The whole, its statements and its last one, which gives the result. *)
