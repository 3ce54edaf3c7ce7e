(** A syntax error: the token at which the parser stops, and the text around it. *)

open Syntax

type t = {
  text : string;  (** the whole source *)
  state : int;  (** state of the parser's automaton *)
  before : Layout.token option;  (** [None] at the start of an item *)
  token : Layout.token;
  context : Layout.context;  (** the blocks and brackets that are open before the token *)
}

type rule = t -> string option
(** Returns a hint if the rule applies. *)

(** {1 Blocks and brackets} *)

val innermost : Layout.context -> (Layout.block * Layout.origin) option
val innermost_block : Layout.context -> Layout.block
val in_brackets : Layout.context -> bool
val opens_with : Layout.opener -> Layout.context -> bool

val compares : Layout.context -> bool
(** Does the context require a value, so that a definition cannot occur here? *)

(** {1 Characters} *)

val char_at : t -> int -> char
(** The character at this offset, or a newline if the offset is outside the text. *)

val after : t -> char
(** The character after the token. *)

val is_blank : char -> bool
val is_symbol : char -> bool

(** {1 Words, each given by its start and end offsets} *)

val written : t -> Layout.token -> string

val is_adjacent : t -> Layout.token -> bool
(** Does the given token end where the erroneous token starts, without whitespace between them? *)

val word_from : t -> int -> int * int

val first_word_from : t -> int -> int * int
(** The first word after the whitespace at this offset. *)

val part : t -> int * int -> string

val first_word : t -> string
(** The word at the left margin of the token's line, often a keyword from another language. *)

val first_word_of_line : t -> string
(** The first word of the token's line, after the indentation. *)

val word_before : t -> int -> string
(** The word before the offset, possibly separated from it by whitespace. *)

val stands_after : t -> string -> Layout.token -> bool

val names_before : t -> string -> bool
(** Does the token's line contain this word before the token? *)

(** {1 Lines} *)

val between : t -> int -> int -> string
(** The text between two offsets, without leading and trailing whitespace. *)

val end_of_line : t -> int -> int

val start_of_definition : t -> int
(** The start of the top-level definition that contains the token. *)

val first_line_of_definition : t -> string

val lines_between : t -> int -> int -> int
(** The number of newlines between the two offsets. *)

(** {1 Places} *)

val span : Layout.token -> Basis.Span.t

val opener_span : Layout.origin -> Basis.Span.t
(** The place of an opening bracket, or of the word that opened a block. *)
