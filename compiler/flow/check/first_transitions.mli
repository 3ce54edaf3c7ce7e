(** Which transitions a mode may take at its own first instant.

    The first instant of each mode of a machine is evaluated with the input unknown: delays have
    their initial value; times, integrals and derivatives are 0; numbers are ranges.

    A mode's parameter is the join of all that is passed for it, at any instant; after three rounds
    a bound that still moves is infinite. Where all this is too much work, a transition may be
    taken. *)

type t

val of_program : ?patient:bool -> Ir.program -> t
(** For a causal program. [patient]: a bound of an Int that moves stays at the numbers written in
    the program before it becomes infinite. *)

val of_machine : t -> Ir.machine -> Ir.transition list array
(** By the machine's modes, in their order: the transitions, physically those of the mode's node, in
    their order. *)

(** {1 With what is known on the way}

    Within an instant all modes have the same input. So what made one of them go says something
    about the input that the next one has, and a parameter may be a part of it. *)

type state = {
  mode : int;  (** of the machine's, by number *)
  known : Range.t list;  (** of its parameters, then of its inputs *)
  pattern : int list;
      (** of each of them the first that is the same; empty where all may be different *)
}
(** How a mode may be entered. *)

val from_running : t -> int -> (Ir.transition * state) list
(** By this node's own transitions, as a mode that may have run for any time. *)

val from_owner : t -> int -> Ir.machine -> Ir.transition list -> (Ir.transition * state) list
(** By the start or the controls of a machine of this node. *)

val from_state : t -> int -> state -> (Ir.transition * state) list
(** By this node's own transitions, as a mode that has just been entered so. *)

val cannot_be_true : t -> int -> Ir.signal -> bool
(** [cannot_be_true a mode] evaluates the first instant of this node of the program once, and then
    tells of each of its signals whether it is certainly no True there. *)
