(** Arithmetic (language reference, section 4, "Numbers are total"). *)

(** 32-bit integers that wrap around. *)
module Int : sig
  val absolute : int32 -> int32
  val signum : int32 -> int32

  val div : int32 -> int32 -> int32
  (** Rounds toward minus infinity. Returns 0 for a division by 0. *)

  val modulo : int32 -> int32 -> int32
  (** The remainder of {!div}; 0 for a division by 0. *)

  val bitwise : Core.Primitive.bitwise -> int32 -> int32 -> int32

  val power : int32 -> int -> int32
  (** The exponent must not be negative. *)
end

module Float : sig
  val nan : float
  (** The only NaN, which is quiet. Before version 5.1, OCaml's [nan] was a signalling NaN, for
      which the C library's [pow nan 0] is not 1. *)

  val signum : float -> float
  (** Returns zeros and NaN unchanged. *)

  val minimum : float -> float -> float
  (** NaN if either argument is NaN; the first argument if both are equal. *)

  val maximum : float -> float -> float
  (** {1 Arithmetic in a precision}

      The arguments are numbers of this precision, and the result is rounded to it. *)

  val add : Basis.Real.t -> float -> float -> float
  val subtract : Basis.Real.t -> float -> float -> float
  val multiply : Basis.Real.t -> float -> float -> float
  val divide : Basis.Real.t -> float -> float -> float
  val pow : Basis.Real.t -> float -> float -> float
  val power : Basis.Real.t -> float -> int -> float
  val elementary : Basis.Real.t -> Core.Primitive.elementary -> float list -> float
end

(** {1 Conversions}

    NaN becomes 0. Numbers that are out of range saturate. *)

val round : float -> int32
(** Rounds to the nearest integer, ties away from zero. *)

val floor : float -> int32
val ceiling : float -> int32
val truncate : float -> int32
