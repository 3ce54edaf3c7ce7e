(** Messages about instances in places that are not evaluated at every instant, with suggested
    alternatives. The places: outside all procs ([E0341]), in branches and guards ([E0342]), in
    functions ([E0343]). *)

open Basis
open Typing

val name : Ir.expr -> string
(** The name, in messages, of the signal function that the expression runs. *)

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
