(** Text to tokens (language reference, section 11), without layout.

    Never fails: what cannot be a token is reported, and a [BAD] token takes its place. Linear in
    the text; keeps no more than one token. *)

open Basis

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;
  column : int;  (** where the token starts as a reader counts: characters from 1, not bytes *)
  first : bool;  (** first on its line *)
  doc : string option;  (** the [-- |] comment before it *)
}

type t

val create : Diagnostic.sink -> file:string -> string -> t
(** The text must be UTF-8; see {!Basis.Utf8}. *)

val copy : t -> t
(** To read on from the same place twice. *)

val text_follows : t -> bool
(** Is the next token a text? *)

val next : t -> token
(** The next token; at the end of the text, [END] again and again. *)

val keywords : string list
(** The words of the language, which cannot be names. *)

val punctuation_symbols : string list
(** That are no operators. *)
