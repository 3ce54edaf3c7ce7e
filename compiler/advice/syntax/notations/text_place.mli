(** The parts of a text around an offset. *)

val char_at : string -> int -> char
(** The character at this offset; a null character outside the text. *)

val ending : string -> int -> (char -> bool) -> string
(** The longest run of characters that ends before this offset and satisfies the predicate. *)

val line_start : string -> int -> int
(** The offset of the start of the line that contains this offset. *)

val start_of_line : string -> int -> int
(** The offset of the start of this line. Lines are numbered from 1. *)

val offset : string -> Basis.Span.position -> int
(** The offset of this position. *)

val end_of_line : string -> int -> int
(** The offset of the end of the line that contains this offset. *)

val without_closing : string -> string
(** The text up to the first unmatched closing parenthesis, without leading or trailing spaces. *)

val find : ?from:int -> string -> string -> int option
(** [find part text] is the offset of the first occurrence of [part], at [from] or later. *)

val is_a_name : string -> bool
(** Whether a word has the form of a variable's name. *)

val replaced : name:string -> by:string -> string -> (int * string) option
(** The number of occurrences of the name in an expression, and the expression with each occurrence
    replaced by this text. [None] if the name does not occur. *)
