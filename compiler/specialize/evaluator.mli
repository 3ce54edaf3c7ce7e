(** Evaluation, as it is given to those who take parts of it over. *)

open Basis

type position = {
  context : Context.t;
  trail : Context.trail;
  types : Types.table;  (** the context's *)
  node : Node.t;
  span : Span.t;
}
(** Where an equation is to stand. *)

type t = {
  run : position -> result:Core.Ir.ty -> Value.t -> Value.argument -> Value.t;
      (** A signal function's output; a proc's equations stand in the node itself. *)
  apply : position -> result:Core.Ir.ty -> Value.t -> Value.argument list -> Value.t;
  static : position -> Value.closure -> Core.Ir.expr -> Value.t;
      (** An expression in a proc that mentions no signal of it. *)
}
