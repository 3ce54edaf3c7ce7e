(** The evaluator as a record, to break the recursion between the modules for the individual
    constructs. *)

open Basis

type position = {
  context : Context.t;
  trail : Context.trail;
  types : Types.table;  (** the types table of the context *)
  node : Node.t;
  span : Span.t;
}
(** The place at which an equation is added. *)

type t = {
  run : position -> result:Core.Ir.ty -> Value.t -> Value.argument -> Value.t;
      (** Runs a signal function and returns its output. Adds the equations of a proc directly to
          the position's [node]. *)
  apply : position -> result:Core.Ir.ty -> Value.t -> Value.argument list -> Value.t;
  static : position -> Value.closure -> Core.Ir.expr -> Value.t;
      (** Evaluates an expression in a proc. The expression must not mention any of the proc's
          signals. *)
}
