(** Exact rational numbers, and their rounding to machine numbers.

    The value of a literal is its exact decimal value times the exact scale of its unit, rounded
    once (language reference, section 4). Pi is represented with 100 decimal places, far more than
    the rounding of any literal needs. *)

type t

val zero : t
val one : t
val of_int : int -> t

val of_literal : string -> t option
(** Parses [digits[.digits][(e|E)[+-]digits]], or [0x], [0o] or [0b] followed by digits of that
    base, optionally with [_] between digits. [None] if the text has a different form, or if its
    exponent is outside ±400. *)

val base_of_prefix : char * char -> int option
(** The base that a literal's first two characters denote. *)

val value_of_digit : char -> int option
(** The value of a digit in any base up to 16. *)

val pi : t
val negate : t -> t
val add : t -> t -> t
val multiply : t -> t -> t

val divide : t -> t -> t
(** The divisor must not be zero. *)

val power : t -> int -> t
val compare : t -> t -> int
val equal : t -> t -> bool

val to_int32 : t -> int32 option
(** [None] unless the number is an integer in range. *)

val to_float : t -> float
(** The nearest double, ties to even; infinity beyond the range. *)

val to_single : t -> float
(** The nearest single-precision number, ties to even; infinity beyond the range. *)

val to_string : t -> string
(** A readable exact representation: an integer, a finite decimal, or [p/q]. *)
