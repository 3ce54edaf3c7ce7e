(** Prints the trees of a language for dumps, with line breaks.

    Strings are printed one by one instead of by [fprintf "%a"], which needs much more stack:
    expressions may be nested ten thousand deep. *)

type 'a t = {
  out : Format.formatter;
  names : Unique_names.t;  (** unique names for the variables of the current definition *)
  own : 'a;  (** data of the printer of one language *)
}

val create : Format.formatter -> 'a -> 'a t
val put : _ t -> string -> unit

val cut : _ t -> unit
(** A place for a line break. *)

val space : _ t -> unit
(** A space, or a line break. *)

val parenthesized : _ t -> bool -> (unit -> unit) -> unit
(** Puts parentheses around what is printed, if the condition is true. *)

(** {1 Boxes}

    The number is the indentation of the lines after the first one. *)

val hov : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks a line only where it is too long. *)

val hv : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks at each place, or nowhere. *)

val vertical : _ t -> ?parentheses:bool -> int -> (unit -> unit) -> unit
(** Breaks at each place. *)

(** {1 Lists} *)

val words : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a space before each part. *)

val breakable_words : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a space or a line break before each part. *)

val lines : _ t -> ('a -> unit) -> 'a list -> unit
(** Starts a line before each part, in a vertical box. *)

val separated : _ t -> ('a -> unit) -> 'a list -> unit
(** Prints a comma between parts. *)

val tuple : _ t -> ('a -> unit) -> 'a list -> unit
val array : _ t -> ('a -> unit) -> 'a list -> unit

(** {1 Texts} *)

val operator : string -> string
(** The name, in parentheses if it is an operator. *)

val is_infix : string -> bool

val number : Exact.t -> string
(** The exact number, or 17 digits of a long one. *)
