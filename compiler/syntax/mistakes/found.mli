(** Where the text breaks off: the token at which the grammar stops, and what stands around it. *)

type t = {
  text : string;  (** the whole source *)
  state : int;  (** of the automaton *)
  before : Layout.token option;  (** [None] at the start of an item *)
  token : Layout.token;
  context : Layout.context;  (** what was open before the token *)
}

(** {1 Blocks and brackets} *)

val innermost : Layout.context -> (Layout.block * Layout.origin) option
val innermost_block : Layout.context -> Layout.block
val in_brackets : Layout.context -> bool
val opens_with : Layout.opener -> Layout.context -> bool

val compares : Layout.context -> bool
(** A value stands here, and no definition can. *)

val expects_more : Layout.token option -> bool
(** Can no expression, type or definition end after this token? *)

(** {1 Characters} *)

val char_at : t -> int -> char
(** A line's end outside of the text. *)

val after : t -> char
(** The one behind the token. *)

val is_blank : char -> bool
val is_symbol : char -> bool
val is_digit : char -> bool

(** {1 Words, each by the offsets of its start and its end} *)

val written : t -> Layout.token -> string

val is_adjacent : t -> Layout.token -> bool
(** No blank is between that one and the token. *)

val word_from : t -> int -> int * int

val first_word_from : t -> int -> int * int
(** Behind blanks. *)

val part : t -> int * int -> string

val first_word : t -> string
(** At the left edge of the line: what other languages begin it with. *)

val first_word_of_line : t -> string
(** Of the token's line, behind its blanks. *)

val word_before : t -> int -> string
(** That ends before the offset, with only blanks between. *)

val stands_after : t -> string -> Layout.token -> bool

(** {1 Lines} *)

val between : t -> int -> int -> string
(** Without blanks at its ends. *)

val end_of_line : t -> int -> int

val start_of_definition : t -> int
(** Of that at the left edge that the token is in. *)

val first_line_of_definition : t -> string

val lines_between : t -> int -> int -> int
(** How many end between the two offsets. *)
