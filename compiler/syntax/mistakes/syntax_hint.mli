(** What the programmer probably meant, where the text breaks off.

    Newcomers bring habits from Haskell, C and Python; this knows the common
    ones by the token at which the grammar stops and what stands around it. *)

type found = {
  text : string;  (** the whole source *)
  state : int;  (** of the automaton *)
  before : Layout.token option;  (** [None] at the start of an item *)
  token : Layout.token;
  context : Layout.context;  (** what was open before the token *)
}

val own_operator : string
val no_procedures : string
val by_equation : string
(** Hints for who writes operators or procedures of his own. *)

val innermost_block : Layout.context -> Layout.block

val expects_more : Layout.token option -> bool
(** Can no expression, type or definition end after this token? *)

val by_indentation : string
(** Hint for who writes blocks in braces. *)

val first_word_of_line : found -> string
(** Of the token's line, behind its blanks. *)

val first_line_of_definition : found -> string
(** Of the definition at the left edge that the token is in. *)

val hint : found -> state_hints:string list -> string list
(** What the token suggests; else what was said for the automaton's state; else
    what usually goes wrong at such a token. *)

val foreign : found -> (string * Basis.Span.t) option
(** The word or operator of other languages at which the text breaks off, and where it is. *)

val other_place : found -> Basis.Diagnostic.t -> Basis.Diagnostic.t
(** Labels what the token should have gone with, if that is on another line. *)
