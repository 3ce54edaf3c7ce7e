(** The evaluator: expressions, applications, runs and the equations of procs.

    Core is evaluated as far as it is static; the rest becomes equations and instances of the node
    under construction. *)

open Basis

type scope = {
  locals : Value.environment;
  types : Value.substitution;
  node : Node.t;
  owner : string;  (** names functions that have no name of their own *)
  trail : Context.trail;
}

val bind : Core.Ir.binder -> Core.Ir.ty -> Value.t -> Value.environment -> Value.environment
(** A variable, its closed type and its value. *)

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
(** An instance of a signal function on its input, and the closed type of its output. *)

val proc_body : Context.t -> scope -> Core.Ir.proc -> Value.t
(** The output of a proc whose input is bound, with its equations in the scope's own node. *)
