(** Dependencies between signals within one instant.

    Leaves that the causality check treats as one ([signal.group]) share one vertex. An instance is
    transparent: each of its outputs needs those inputs from which its node computes that output in
    the same instant, and the static parameters. A loop is a black box: each of its outputs needs
    all its inputs. A machine is also a black box. Each of its outputs needs the controls that are
    not delayed, and everything that any mode needs for an output or for a transition that is not
    delayed. *)

type definition =
  | Parameter  (** a static parameter or an input of the node *)
  | Equation of Ir.equation
  | Output of Ir.instance * int  (** an output of this instance, by index *)
  | Box of Ir.atom list
      (** an output of the machine or a result of foreign C code, with everything it needs in the
          same instant *)

module Inputs : Set.S with type elt = int

type passage = {
  passed : Inputs.t array;  (** for each output, the indices of the inputs it needs *)
  decisive : Inputs.t;
      (** the inputs needed by transitions that are not delayed; such transitions affect the output
          in the same instant *)
}
(** The properties of a node that its callers need. *)

type node = {
  graph : Basis.Graph.t;  (** the dependency graph; an edge means "needs in the same instant" *)
  definitions : definition list array;  (** definitions of the leaves in each vertex *)
  vertex : Ir.signal -> int;  (** the vertex of one of the node's own signals *)
  components : int list list;  (** strongly connected components of [graph] *)
  passage : passage;
}

val program : ?each:(passage array -> int -> node -> unit) -> Ir.program -> passage array
(** Computes the {!passage} of every node, callees first. Calls [each] for one node at a time, with
    the results for the preceding nodes, because keeping the graphs of all nodes would take too much
    memory. *)

val passed_by : passage -> Ir.instance -> int -> Inputs.t
(** For an instance of the node: the indices of the inputs that this output needs. *)

val reads : passage array -> definition -> Ir.signal list
(** The signals that a definition needs in the same instant. *)
