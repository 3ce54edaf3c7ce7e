(** The topics of messages about syntax that other messages ask for. *)

open Basis

(** The subjects of hints about the whole program or block. Each of them is only mentioned once. *)
type shared =
  | Own_operator
  | No_procedures
  | Function_by_equation
  | End_of_block
  | Waiting
  | No_effect
  | Record_declaration of string  (** the declaration that the hint suggests *)

type Diagnostic.topic +=
  | Shared of shared
  | Function_keyword  (** Frob has no `function` *)
  | Block_in_braces
  | Changed_copy  (** a record with other fields, written in braces *)
  | Choice of string  (** a choice between values, and its notation in Frob *)
  | Colon_of_a_block
  | Class_of_objects
  | Switch of string  (** the value of a C `switch`, and its notation in Frob *)

val suggestion : shared -> string -> Diagnostic.hint

val text : string -> Diagnostic.hint
(** A hint without a topic. *)
