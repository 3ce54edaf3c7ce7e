(** Loops over arrays: a node that is made for one round, and the instance that runs it for each. *)

type argument = {
  form : Flow.Ir.argument;
  ty : Core.Ir.ty;  (** closed; of what one round gets; first-order *)
  value : Value.t;
      (** the initial value, the array, or the number to count from; [Same] is for what is captured,
          see below *)
  local : Core.Ir.Local.t;  (** names the node's inputs *)
}

type request = {
  name : string;  (** of the node *)
  kind : Flow.Ir.kind;
  count : int;
  key : string;  (** tells apart what is captured alike and does something else *)
  captured : Value.argument list;
      (** used in every round as it is; in a signal function it is static *)
  arguments : argument list;  (** accumulators first *)
  final : Core.Ir.ty list;  (** of each accumulator *)
  elements : Core.Ir.ty list;  (** of the elements of the arrays that come out *)
}

val run :
  Evaluator.position ->
  Node.target list ->
  request ->
  (Evaluator.position -> Value.t list -> Value.t list -> Value.t list) ->
  Value.t list
(** The final accumulators, and the arrays; a target for each. The function is one round, in a node
    of its own: from what is captured and the arguments to the next accumulators and the elements.
    May raise {!Context.Postponed}. *)
