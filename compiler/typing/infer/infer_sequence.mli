(** Checks [do] notation: tasks that run one after the other. The result consists of applications of
    {!Environment.sequence}, in which the remaining statements form a function of the previous
    task's result. *)

open Context

val check :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  Resolve.Ir.statement list ->
  Resolve.Ir.expr ->
  Expected.t ->
  Ir.expr later
(** Takes the whole [do], its statements, and its last expression, which determines the result. *)
