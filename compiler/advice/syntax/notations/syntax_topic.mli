(** Topics of syntax messages. A message is omitted if the topics of earlier messages show that it
    adds nothing. *)

open Basis

(** The subjects of hints about the whole program or block. Each subject is mentioned only once. *)
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
  | Function_keyword  (** the message that Frob has no `function` *)
  | Block_in_braces
  | Changed_copy  (** a record update, written in braces *)
  | Choice of string  (** a choice, translated into Frob *)
  | Colon_of_a_block
  | Class_of_objects
  | Switch of string  (** a C `switch`, translated into Frob *)

val suggestion : shared -> string -> Diagnostic.hint

val text : string -> Diagnostic.hint
(** A hint without a topic. *)
