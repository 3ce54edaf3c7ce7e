(** Arithmetic (language reference, section 4, "Numbers are total"). *)

(** Whole numbers of 32 bits, which wrap around. *)
module Int : sig
  val absolute : int32 -> int32
  val signum : int32 -> int32

  val div : int32 -> int32 -> int32
  (** Rounds to minus infinity; by 0 it is 0. *)

  val modulo : int32 -> int32 -> int32
  (** What {!div} leaves; by 0 it is 0. *)

  val bitwise : Core.Primitive.bitwise -> int32 -> int32 -> int32

  val power : int32 -> int -> int32
  (** The exponent is not negative. *)
end

module Float : sig
  val nan : float
  (** The one NaN: quiet, unlike OCaml's own before 5.1, with which the C library's [pow nan 0] is
      not 1. *)

  val signum : float -> float
  (** Zeros and NaN are their own. *)

  val minimum : float -> float -> float
  (** NaN if either is; else the first of two equal ones. *)

  val maximum : float -> float -> float
  (** {1 In a precision} Of numbers of that precision, the nearest of it. *)

  val add : Basis.Real.t -> float -> float -> float
  val subtract : Basis.Real.t -> float -> float -> float
  val multiply : Basis.Real.t -> float -> float -> float
  val divide : Basis.Real.t -> float -> float -> float
  val pow : Basis.Real.t -> float -> float -> float
  val power : Basis.Real.t -> float -> int -> float
  val elementary : Basis.Real.t -> Core.Primitive.elementary -> float list -> float
end

(** {1 Conversions} NaN gives 0; what is out of range, the nearest in range. *)

val round : float -> int32
(** Halves away from zero. *)

val floor : float -> int32
val ceiling : float -> int32
val truncate : float -> int32
