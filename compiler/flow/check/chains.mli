(** How far switches may lead within one instant, from state to state of what is known.

    Finds out more than {!First_transitions.of_machine}, and takes longer: a mode that counts is a
    state for each number. *)

open Basis

type hop = { from : int; by : Ir.transition }
(** A mode, by its number among the machine's, and its transition at its first instant. *)

type outcome =
  | Ends of { steps : int; possible : Ir.transition list array }
      (** how many modes an instant steps at most; by mode the transitions that may occur at its
          first instant, physically those of its node *)
  | Goes_round of hop list  (** a shortest circle *)
  | Goes_far  (** more than {!most} steps, or too many ways *)

val most : int

val lengths : Graph.t -> int list list -> int array
(** How many vertices there are at most from each on, itself included, of a graph without circles
    and its {!Graph.components}. *)

val of_machine : First_transitions.t -> int -> Ir.machine -> outcome
(** Of this node's machine. *)
