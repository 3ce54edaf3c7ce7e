(** Messages about instances in places that are not evaluated at every instant, with suggested
    alternatives. The places: outside all procs ([E0341]), in branches and guards ([E0342]), in
    functions ([E0343]). *)

open Basis
open Typing

val name : Ir.expr -> string
(** How messages refer to this signal function: by its name in backticks or, if it has none, as "a
    signal function". *)

val diagnostic :
  Source.t ->
  definition:Ir.Global.t ->
  within:Ir.expr ->
  Level_fact.position ->
  Level_fact.obstacle ->
  Ir.expr ->
  head:Ir.expr ->
  input:Ir.expr ->
  Diagnostic.t
(** The message about an expression that runs [head] on [input]. [within]: the right-hand side of
    [definition], which contains the expression. The position must not be [Every_instant]. *)
