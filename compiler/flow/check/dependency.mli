(** Who needs whose value within one instant.

    The unit is the group of leaves that causality judges as one ([signal.group]). An instance is
    transparent: each of its outputs needs those inputs that its node passes on to that output in
    the same instant, and the statics; a loop is one box. A machine is a box: each of its outputs
    needs whatever any of its modes needs for any output, or for a transition that is not delayed,
    and the controls that are not delayed. *)

type definition =
  | Parameter  (** a static or an input of the node *)
  | Equation of Ir.equation
  | Output of Ir.instance * int  (** the instance's output of that number *)
  | Box of Ir.atom list
      (** an output of the machine, or a result of C, and what it needs in the same instant *)

module Inputs : Set.S with type elt = int

type passage = {
  passed : Inputs.t array;  (** for each output, the numbers of the inputs it needs *)
  decisive : Inputs.t;
      (** the inputs that the transitions need which change the output of the instant: those not
          delayed *)
}
(** What callers have to know of a node. *)

type node = {
  graph : Basis.Graph.t;  (** an edge means "needs in the same instant" *)
  definitions : definition list array;  (** of the leaves of each vertex *)
  vertex : Ir.signal -> int;  (** for the node's own signals *)
  components : int list list;  (** of [graph] *)
  passage : passage;
}

val program : ?each:(passage array -> int -> node -> unit) -> Ir.program -> passage array
(** Of all nodes. [each] sees one at a time, callees first, with the passages of those before it:
    the graphs of all at once would be much to keep. *)

val passed_by : passage -> Ir.instance -> int -> Inputs.t
(** Of an instance of the node: the numbers of the inputs that its output of that number needs. *)

val reads : passage array -> definition -> Ir.signal list
(** What a definition needs in the same instant. *)
