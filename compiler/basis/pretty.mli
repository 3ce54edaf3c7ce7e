(** Prints the trees of an intermediate language for dumps, with line breaks.

    Strings are printed one by one instead of with [fprintf "%a"], which needs much more stack:
    expressions may be nested ten thousand deep. *)

type 'a t = {
  out : Format.formatter;
  names : Unique_names.t;  (** unique names for the variables of the current definition *)
  own : 'a;  (** data for the printer of a specific language *)
}

val create : Format.formatter -> 'a -> 'a t
val put : _ t -> string -> unit

val cut : _ t -> unit
(** Allows a line break here. *)

val space : _ t -> unit
(** Prints a space, or a line break. *)

val parenthesized : _ t -> bool -> (unit -> unit) -> unit
(** Puts parentheses around the output of the function if the condition is true. *)

(** {1 Boxes}

    The number is the indentation of the lines after the first one. *)

val hov : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks the line at a break hint only if the line would be too long. *)

val hv : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks the line at every break hint, or at none. *)

val vertical : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks the line at every break hint. *)

(** {1 Lists} *)

val words : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a space before each part. *)

val breakable_words : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a space or a line break before each part. *)

val lines : _ t -> ('a -> unit) -> 'a list -> unit
(** Starts a new line before each part, in a vertical box. *)

val separated : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a comma between parts. *)

val tuple : _ t -> ('a -> unit) -> 'a list -> unit
val array : _ t -> ('a -> unit) -> 'a list -> unit

(** {1 Texts} *)

val operator : string -> string
(** The name, in parentheses if it is an operator. *)

val is_infix : string -> bool

val number : Exact.t -> string
(** The exact number, or its first 17 significant digits if it is long. *)
