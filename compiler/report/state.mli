(** The layout of the state: the struct of each definition, member by member. *)

open State_layout

type t

val of_program : Step.Ir.program -> t
val root : t -> int

val definition : t -> int -> definition
(** The struct of a node with state, or of the root. *)

val in_use : t -> int list
(** The indices of the definitions whose structs are part of the root's state, in depth-first order
    from the root, without duplicates. *)

val padding : bytes:int -> member list -> int
(** The number of padding bytes in a struct of [bytes] bytes with these members. *)

val foreign : Step.Ir.program -> string list
(** The user's C structs that are part of the state. No size in this module includes them. *)

val params_bytes : Step.Ir.program -> int
(** Size of the parameter struct. There is one such struct for each set of parameter values. *)
