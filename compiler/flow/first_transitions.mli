(** Which transitions a mode may take at its own first instant.

    The first instant of each mode of a machine is evaluated with the input
    unknown: delays have their initial value; times, integrals and derivatives
    are 0; numbers are ranges.

    A mode's parameter is the join of all that is passed for it, at any
    instant; after three rounds a bound that still moves is infinite. Where all
    this is too much work, a transition may be taken. *)

type t

val of_program : Ir.program -> t
(** For a causal program. *)

val of_machine : t -> Ir.machine -> Ir.transition list array
(** By the machine's modes, in their order: the transitions, physically those of the
    mode's node, in their order. *)

val cannot_be_true : t -> int -> Ir.signal -> bool
(** [cannot_be_true a mode] evaluates the first instant of this node of the program
    once, and then tells of each of its signals whether it is certainly no True there. *)
