(** The code of an instance: a call, a step of its copy of the node, a loop of such steps, or a
    trial.

    An instance without state that has one result is a value, to be placed like any other; all
    others are actions. [resolve] looks through copies. *)

type context = {
  program : Flow.Ir.program;
  callee : int -> Ir.node;  (** the nodes already translated *)
  fresh : unit -> int;  (** an id that no signal and no variable has *)
}

val call :
  context -> (Flow.Ir.atom -> Flow.Ir.atom) -> Flow.Ir.instance -> Ir.field option -> Fragment.item
(** A step, with the field of its state if it has one. *)

val try_out :
  context ->
  (Flow.Ir.atom -> Flow.Ir.atom) ->
  Flow.Ir.instance ->
  Flow.Ir.trial ->
  Ir.field option ->
  Fragment.item
(** A step for those results that the trial gives; inputs that are not known yet are zero. *)

val reset :
  context -> (Flow.Ir.atom -> Flow.Ir.atom) -> Flow.Ir.instance -> Ir.field -> Fragment.item
