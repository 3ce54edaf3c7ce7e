(** The chains of transitions that a machine may take in one instant, as a graph of states. A state
    consists of a mode and the known ranges of its parameters and inputs.

    This analysis is more precise than {!First_transitions.of_machine}, but slower, because a mode
    that counts has one state for each value of the counter. *)

open Basis

type hop = { from : int; by : Ir.transition }
(** The number of a mode, and a transition that it may take in its first instant. *)

type outcome =
  | Ends of { steps : int; possible : Ir.transition list array }
      (** [steps]: the maximum number of modes that run in one instant. [possible]: for each mode,
          the transitions that may occur in its first instant, physically equal to those of its node
      *)
  | Goes_round of hop list  (** a shortest cycle *)
  | Goes_far  (** more than {!most} modes may run in one instant, or there are too many states *)

val most : int

val lengths : Graph.t -> int list list -> int array
(** For an acyclic graph and its {!Graph.components}: the number of vertices on the longest path
    that starts at each vertex. *)

val of_machine : First_transitions.t -> int -> Ir.machine -> outcome
(** Analyses the machine of the node with this index. *)
