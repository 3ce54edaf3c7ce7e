(** Translates an instance to a call, a step, a loop of steps, or a trial step.

    A stateless instance with one result becomes a value, which is placed like any other value;
    every other instance becomes an action. [resolve] resolves copies. *)

type context = {
  program : Flow.Ir.program;
  callee : int -> Ir.node;  (** returns a node that is already translated *)
  fresh : unit -> int;  (** an id that no signal or variable has *)
}

val call :
  context -> (Flow.Ir.atom -> Flow.Ir.atom) -> Flow.Ir.instance -> Ir.field option -> Fragment.item
(** A step of an instance. The field contains the instance's state, if it has any. *)

val try_out :
  context ->
  (Flow.Ir.atom -> Flow.Ir.atom) ->
  Flow.Ir.instance ->
  Flow.Ir.trial ->
  Ir.field option ->
  Fragment.item
(** A trial step that computes some of the results. Inputs that are not known yet are replaced by
    zero. *)

val reset :
  context -> (Flow.Ir.atom -> Flow.Ir.atom) -> Flow.Ir.instance -> Ir.field -> Fragment.item
