(** The precision of the language's [Float]: IEEE 754 binary64 or binary32.

    In OCaml both are [float]; a single is a double that binary32 can hold. An operation on singles
    is done on doubles and then rounded. For [+ - * /] and [sqrt] that gives the same as one
    rounding, because a double has at least twice the bits of a single and two more (S. A. Figueroa,
    "When is double rounding innocuous?", ACM SIGNUM Newsletter 30, 1995). *)

type t = Double | Single

val round : t -> float -> float
(** To the nearest of the precision, ties to even. *)

val of_int64 : t -> int64 -> float
(** Likewise, with one rounding. *)

val of_exact : t -> Exact.t -> float
(** Likewise, with one rounding; infinite beyond the range. *)

val bytes : t -> int
(** In memory, which is also the alignment. *)

val shortest : t -> float -> string
(** Of a finite number: the fewest decimal digits that are read back as the same number, as [%g]
    writes them. What reads them may round to a double first. *)

val all_whole_from : t -> float
(** From this power of two on each number is whole: 2⁵² or 2²³. *)
