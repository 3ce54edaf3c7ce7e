(** Where the bytes of the state are: the struct of each definition, member by member. *)

open Basis

type member = {
  name : string;  (** the programmer's *)
  offset : int;  (** in its struct *)
  bytes : int;
  holds : holds;
  span : Span.t;
}

and holds =
  | Value of string  (** for the reader: [delay], [integral], … *)
  | Struct of int  (** the number of a definition: a node, or its small fields *)
  | Structs of { node : int; count : int }  (** an array of them *)
  | Running_mode
  | Largest of alternative list  (** modes, which share this room *)

and alternative = { mode : string; node : int; bytes : int; members : member list }
(** The struct that a mode's members make. *)

type definition = {
  name : string;  (** the definition as the programmer knows it *)
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
(** Of a node with state, or the root. *)

val in_use : t -> int list
(** The definitions that the root's holds, itself first, each before those it holds and each once.
*)

val padding : bytes:int -> member list -> int
(** What of a struct no member has. *)

val foreign : Step.Ir.program -> string list
(** The structs of the user's C in the state. Their size is in no number here. *)

val params_bytes : Step.Ir.program -> int
(** The size of the struct of the parameters, of which there is one for each set of values. *)
