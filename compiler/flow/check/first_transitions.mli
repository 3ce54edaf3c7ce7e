(** Determines which transitions a mode may take in its own first instant.

    Evaluates the first instant of each mode with unknown inputs: delays have their initial values;
    times, integrals and derivatives are 0; numbers are represented by ranges.

    The range of a mode's parameter is the join of the ranges of all arguments passed to it, over
    all instants. After three rounds, bounds that still change are widened to infinity. If the
    analysis would take too long, all transitions are considered possible. *)

type t

val of_program : ?patient:bool -> Ir.program -> t
(** The program must be causal. If [patient] is true, the bounds of Ints are first widened to the
    literals in the program, and only then to infinity. *)

val of_machine : t -> Ir.machine -> Ir.transition list array
(** For each mode, in the machine's order, its possible transitions, in their original order. They
    are physically equal to those of the mode's node. *)

(** {1 Chains of transitions}

    All modes have the same input within an instant. Therefore the condition under which one mode
    was left restricts the possible input of the next mode, and also its parameters if part of the
    input is passed as a parameter. *)

type state = {
  mode : int;  (** number of the mode within the machine *)
  known : Range.t list;  (** ranges of its parameters, then of its inputs *)
  pattern : int list;
      (** for each of these values, the index of the first value that is certainly equal to it;
          empty if all may be different *)
}
(** A mode that has just been entered, with the known ranges of its parameters and inputs. *)

val from_running : t -> int -> (Ir.transition * state) list
(** The possible transitions of this node, which is a mode that may have been running for any length
    of time. *)

val from_owner : t -> int -> Ir.machine -> Ir.transition list -> (Ir.transition * state) list
(** Those of the given transitions that are possible. Each given transition must belong to the start
    or the controls of this node's machine. *)

val from_state : t -> int -> state -> (Ir.transition * state) list
(** The possible transitions of this node, which is a mode that has just been entered in this state.
*)

val cannot_be_true : t -> int -> Ir.signal -> bool
(** [cannot_be_true a mode] evaluates the first instant of this node once. The returned function
    tells whether a signal is certainly not True in that instant. *)
