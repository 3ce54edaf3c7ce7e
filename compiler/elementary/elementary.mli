(** The runtime's elementary functions ([frob/elementary.h]), so that a number has the same bits
    whether a machine's C computes it or the interpreter. Errors, special cases and sources are
    stated there; angles are in radians. *)

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
  (** [atan2 y x] is the direction of the point [(x, y)]. *)

  val hypot : float -> float -> float
end

val of_precision : Basis.Real.t -> (module S)
(** Those of single precision take and give singles. *)
