(** Exponents of units: small exact fractions. *)

type t = Syntax.Ir.rational
(** In lowest terms, the denominator positive. *)

exception Out_of_range
(** Raised where a numerator or denominator would pass a million: no unit that means anything comes
    near it. *)

val zero : t
val one : t
val of_int : int -> t

val make : int -> int -> t
(** The denominator must not be zero. *)

val add : t -> t -> t
val negate : t -> t
val multiply : t -> t -> t

val inverse : t -> t
(** Of anything but zero. *)

val is_zero : t -> bool
val is_negative : t -> bool
val is_integer : t -> bool
val equal : t -> t -> bool
val to_string : t -> string
