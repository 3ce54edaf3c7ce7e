(** The code of a machine: a mode of it runs in each instant, and may end.

    A mode's node becomes a step function like any other, whose results after those of the machine
    are what its transitions need to know. *)

type context = {
  program : Flow.Ir.program;
  callee : int -> Ir.node;  (** the nodes already translated *)
  kept : State.machine;
  resolve : Flow.Ir.atom -> Flow.Ir.atom;  (** looks through copies *)
}

val variable : Flow.Ir.signal -> Ir.variable

val results_for_transitions : Flow.Ir.node -> Flow.Ir.signal list
(** What a mode's step gives after its outputs. *)

val step : context -> Flow.Ir.machine -> Fragment.item

val start : context -> Flow.Ir.machine -> Fragment.item
(** For the reset: the first mode begins. *)
