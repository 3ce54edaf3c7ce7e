(** The precision of the language's [Float]: IEEE 754 binary64 or binary32.

    In OCaml both are [float]; a single is a double that binary32 can represent. An operation on
    singles is performed on doubles and then rounded. For [+ - * /] and [sqrt] this yields the same
    result as a single rounding, because a double has at least 2p + 2 significand bits, where p is
    the precision of a single (S. A. Figueroa, "When is double rounding innocuous?", ACM SIGNUM
    Newsletter 30, 1995). *)

type t = Double | Single

val round : t -> float -> float
(** Rounds to the nearest number of this precision, ties to even. *)

val of_int64 : t -> int64 -> float
(** Converts to this precision, with one rounding. *)

val of_exact : t -> Exact.t -> float
(** Converts to this precision, with one rounding; infinity beyond the range. *)

val bytes : t -> int
(** The size in bytes, which is also the alignment. *)

val shortest : t -> float -> string
(** The number in the format of [%g], with the fewest decimal digits that read back as the same
    number even if the reader rounds to a double first. The number must be finite. *)

val all_whole_from : t -> float
(** From this power of two on, every number is an integer: 2⁵² or 2²³. *)
