(** The layout of the state: the struct of each definition, member by member. *)

open Basis

type member = {
  name : string;  (** the name in the program *)
  offset : int;  (** the member's offset in its struct *)
  bytes : int;
  holds : holds;
  span : Span.t;
}

and holds =
  | Value of string  (** purpose of the value, as shown to the user: [delay], [integral], … *)
  | Struct of int  (** a struct: the index of the node that it belongs to *)
  | Structs of { node : int; count : int }  (** an array of such structs *)
  | Running_mode
  | Largest of alternative list  (** modes, which share this memory *)

and alternative = { mode : string; node : int; bytes : int; members : member list }
(** A mode, with the members of its struct. *)

type definition = {
  name : string;  (** name of the definition in the program *)
  file : string;
  span : Span.t;
  bytes : int;
  members : member list;
}
(** The state struct of a node. *)

type t

val of_program : Step.Ir.program -> t
val root : t -> int

val definition : t -> int -> definition
(** The struct of a node with state, or of the root. *)

val in_use : t -> int list
(** The indices of the definitions whose structs are part of the root's state, in depth-first order
    from the root, without duplicates. *)

val padding : bytes:int -> member list -> int
(** The number of bytes in a struct that do not belong to any member. *)

val foreign : Step.Ir.program -> string list
(** The user's C structs that are part of the state. No size in this module includes them. *)

val params_bytes : Step.Ir.program -> int
(** Size of the parameter struct. There is one such struct for each set of parameter values. *)
