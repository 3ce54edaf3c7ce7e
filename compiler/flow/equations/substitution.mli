(** Replacing signals of one node by equal atoms.

    A pass adds what it finds and in the end applies it to the whole node. Replacements may be
    chained; what is replaced keeps no definition. *)

type t

val create : unit -> t

val replace : t -> Ir.signal -> Ir.atom -> unit
(** From now on the atom stands for the signal. A name that the programmer gave the signal goes on
    to the atom, if that is a signal without one. *)

val atom : t -> Ir.atom -> Ir.atom

val is_empty : t -> bool
(** Is no signal replaced? *)

val node : t -> Ir.node -> Ir.node
(** The node without equations for replaced signals, the others' operands replaced. Outputs of
    instances stay, read or not. *)
