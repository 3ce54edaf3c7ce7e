(** Translates a machine, which runs one of its modes in each instant.

    The node of a mode becomes a step function like any other. After the machine's results, it
    returns the values that the mode's transitions need. *)

type context = {
  program : Flow.Ir.program;
  callee : int -> Ir.node;  (** returns a node that is already translated *)
  kept : State.machine;
  resolve : Flow.Ir.atom -> Flow.Ir.atom;  (** resolves copies *)
}

val variable : Flow.Ir.signal -> Ir.variable

val results_for_transitions : Flow.Ir.node -> Flow.Ir.signal list
(** The additional results of a mode's step, after its outputs. *)

val step : context -> Flow.Ir.machine -> Fragment.item

val start : context -> Flow.Ir.machine -> Fragment.item
(** The reset: enters the first mode. *)
