(** A mismatch between types of different shapes, with the data that the message rules use. *)

open Basis
open Typing

type t = {
  words : Wording.t;
  subject : Resolve.Ir.expr option;  (** the expression that has the wrong type, if there is one *)
  at : Span.t;
  expected : Expected.t;
  found : Type.t;
  wanted : Type.t;  (** the expected type, expanded *)
  given : Type.t;  (** the type found, expanded *)
}

type Diagnostic.topic += Call of string  (** The hint shows how to call this function. *)

type rule = t -> Diagnostic.t option
(** Returns the message if the rule applies to the mismatch. *)

val make :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  t

val first : (t -> 'a option) list -> t -> 'a option
(** The result of the first rule that applies. *)

(** {1 Properties of the mismatch} *)

val other_operand : t -> Resolve.Ir.expr option
(** The operator's other operand, if it has the type that is expected of the subject. *)

val is_statement : t -> bool
(** Is the subject a statement in a [do]? *)

val is_a_parameter : t -> bool
(** Is the subject an argument of a function, rather than an operand of an arithmetic operator? *)

val callee : t -> string
(** The name of the function that takes the subject as an argument; [f] if there is none. *)

val name : t -> string option
(** The subject, if it is a variable or a constructor. *)

(** {1 Texts} *)

val expected_text : t -> string
(** The text of the expected type, for use in a sentence. *)

val found_text : t -> string
(** The text of the type found, for use in a sentence. *)

val source : t -> string option
(** The source text of the subject, if it is short. *)

val raw : t -> string -> string
(** The source text of the subject, or the given text if there is no subject or its text is too
    long. *)

val grouped : t -> string -> string
(** Like {!raw}, with parentheses around the subject if it needs them as an argument. *)

val elements : t -> string option list
(** The source texts of the components, if the subject is a tuple; otherwise a list that contains
    only [None]. *)

val all : string option list -> string list option
(** All the strings, or [None] if any of them is missing. *)

val names : int -> string list
(** Names for parts that the programmer did not name: [a], [b], … *)

(** {1 Messages} *)

val different : t -> Diagnostic.t
(** The error [E0301], which says that the type found differs from the expected one. *)

val hinted : ?topic:Diagnostic.topic -> t -> ('a, unit, string, Diagnostic.t) format4 -> 'a
(** {!different}, with this hint added. *)

val not_a_condition : t -> Diagnostic.t
(** The error [E0301] about the condition of an [if]. *)

val not_matched : t -> Diagnostic.t
(** The error [E0301] about a pattern whose type differs from that of the value. *)
