(** Loops over arrays: a node that computes one iteration, and an instance that runs the node for
    each element. *)

type argument = {
  form : Flow.Ir.argument;
  ty : Core.Ir.ty;  (** closed and first-order; the type in one iteration *)
  value : Value.t;
      (** the initial value of an accumulator, the array of the elements, or the number to count
          from; the form is never [Same], which is only for captured values (see below) *)
  local : Core.Ir.Local.t;  (** the argument's name, from which the node's inputs get their names *)
}

type request = {
  name : string;  (** the name of the node *)
  kind : Flow.Ir.kind;
  count : int;
  key : string;  (** distinguishes loops with equal captured values but different bodies *)
  captured : Value.argument list;
      (** values used unchanged in every iteration; static in a signal function *)
  arguments : argument list;  (** accumulators first *)
  final : Core.Ir.ty list;  (** types of the final accumulators *)
  elements : Core.Ir.ty list;  (** element types of the resulting arrays *)
}

val run :
  Evaluator.position ->
  Node.target list ->
  request ->
  (Evaluator.position -> Value.t list -> Value.t list -> Value.t list) ->
  Value.t list
(** Returns the final accumulators, then the resulting arrays; there is one target for each. The
    given function builds one iteration in a separate node: from the captured values and the
    arguments, it computes the next accumulators and the elements. May raise {!Context.Postponed}.
*)
