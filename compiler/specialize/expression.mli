(** The evaluator: expressions, applications, runs, and the equations of procs.

    The static part of Core is evaluated. The rest becomes equations and instances of the node under
    construction. *)

open Basis

type scope = {
  locals : Value.environment;
  types : Value.substitution;
  node : Node.t;
  owner : string;  (** the name to use for anonymous functions *)
  trail : Context.trail;
}

val bind : Core.Ir.binder -> Core.Ir.ty -> Value.t -> Value.environment -> Value.environment
(** Binds a variable of this closed type to the value. *)

val expr : Context.t -> scope -> Node.target -> Core.Ir.expr -> Value.t

val run :
  Context.t ->
  scope ->
  Node.target ->
  span:Span.t ->
  result:Core.Ir.ty ->
  Value.t ->
  Value.argument ->
  Value.t
(** Runs an instance of a signal function on its input. [result]: the closed type of its output. *)

val proc_body : Context.t -> scope -> Core.Ir.proc -> Value.t
(** The output of a proc whose input is already bound. Adds the proc's equations to the scope's
    [node]. *)
