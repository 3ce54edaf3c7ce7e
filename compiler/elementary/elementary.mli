(** Bindings to the runtime's elementary functions ([frob/elementary.h]), so that the interpreter
    and compiled programs compute the same bits on every machine. That header documents errors,
    special cases and sources. Angles are in radians. *)

module type S = sig
  val exp : float -> float
  val log : float -> float

  val pow : float -> float -> float
  (** [pow x y] is [x] to the power [y]. *)

  val sin : float -> float
  val cos : float -> float
  val tan : float -> float
  val asin : float -> float
  val acos : float -> float
  val atan : float -> float

  val atan2 : float -> float -> float
  (** [atan2 y x] is the angle from the positive x-axis to the point [(x, y)]. *)

  val hypot : float -> float -> float
end

val of_precision : Basis.Real.t -> (module S)
(** The single-precision functions take and return floats that single precision can represent
    exactly. *)
