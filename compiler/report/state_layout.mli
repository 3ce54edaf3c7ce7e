(** The members of the state structs, with their offsets and sizes. *)

open Basis

type member = {
  name : string;  (** the programmer's name *)
  offset : int;  (** the member's offset in its struct *)
  bytes : int;
  holds : holds;
  span : Span.t;
}

and holds =
  | Value of string  (** purpose of the value, for the user: [delay], [integral], … *)
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
