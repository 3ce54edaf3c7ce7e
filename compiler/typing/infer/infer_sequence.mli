(** Checks [do] notation: tasks that run one after the other.

    It becomes applications of {!Environment.sequence}. The rest of the statements is a function of
    the result of the task before. *)

open Context

val check :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  Resolve.Ir.statement list ->
  Resolve.Ir.expr ->
  Expected.t ->
  Ir.expr later
(** Arguments: the whole [do], its statements, and its last expression, which gives the result. *)
