(** Splits text into tokens (language reference, section 11), ignoring layout.

    Never fails: invalid characters are reported and replaced with a [BAD] token. Takes linear time
    and keeps only one token in memory. *)

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;
  column : int;  (** column of the token's start, in characters (not bytes), counted from 1 *)
  first : bool;  (** whether the token is the first one on its line *)
  doc : string option;  (** the text of the [-- |] comment before the token *)
}

type t

val create : (Lexical_fact.t -> unit) -> file:string -> string -> t
(** Calls the function for each problem. The text must be UTF-8; see {!Basis.Utf8}. *)

val copy : t -> t
(** A copy of the state, for reading the same tokens twice. *)

val text_follows : t -> bool
(** Is the next token a string literal? *)

val is_unit : string -> bool
(** Is this the symbol of a unit of the prelude? *)

val next : t -> token
(** Reads the next token. At the end of the text, returns [END] every time. *)

val keywords : string list
(** The reserved words, which cannot be names. *)

val punctuation_symbols : string list
(** The symbols that are not operators. *)
