(** Exact rational numbers, and their one rounding to a machine number.

    A literal's value is its exact decimal times its unit's exact scale, rounded once (language
    reference, section 4). Pi is taken to 100 decimal places, far beyond what any rounding of a
    literal can see. *)

type t

val zero : t
val one : t
val of_int : int -> t

val of_literal : string -> t option
(** [digits[.digits][(e|E)[+-]digits]], or [0x], [0o], [0b] and digits of that base, all perhaps
    with [_] among the digits; [None] if it is not of that form or its exponent is beyond ±400. *)

val base_of_prefix : char * char -> int option
(** Of a literal's first two characters. *)

val value_of_digit : char -> int option
(** In any base up to 16. *)

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
(** [None] unless an integer in range. *)

val to_float : t -> float
(** The nearest double, ties to even; infinite beyond the range. *)

val to_single : t -> float
(** Likewise the nearest number of single precision. *)

val to_string : t -> string
(** A readable exact form: an integer, a finite decimal, or [p/q]. *)
