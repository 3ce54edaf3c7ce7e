(** Exponents of units: small exact fractions. *)

type t = Syntax.Ir.rational
(** In lowest terms, with a positive denominator. *)

exception Out_of_range
(** Raised if a numerator or denominator would exceed a million. No practical unit comes close to
    that. *)

val zero : t
val one : t
val of_int : int -> t

val make : int -> int -> t
(** The denominator must not be zero. *)

val add : t -> t -> t
val negate : t -> t
val multiply : t -> t -> t

val inverse : t -> t
(** The argument must not be zero. *)

val is_zero : t -> bool
val is_negative : t -> bool
val is_integer : t -> bool
val equal : t -> t -> bool
val to_string : t -> string
