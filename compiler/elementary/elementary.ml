module type S = sig
  val exp : float -> float
  val log : float -> float
  val pow : float -> float -> float
  val sin : float -> float
  val cos : float -> float
  val tan : float -> float
  val asin : float -> float
  val acos : float -> float
  val atan : float -> float
  val atan2 : float -> float -> float
  val hypot : float -> float -> float
end

module Double = struct
  external exp : float -> float = "frob_boxed_exp" "frob_exp" [@@unboxed] [@@noalloc]
  external log : float -> float = "frob_boxed_log" "frob_log" [@@unboxed] [@@noalloc]
  external pow : float -> float -> float = "frob_boxed_pow" "frob_pow" [@@unboxed] [@@noalloc]
  external sin : float -> float = "frob_boxed_sin" "frob_sin" [@@unboxed] [@@noalloc]
  external cos : float -> float = "frob_boxed_cos" "frob_cos" [@@unboxed] [@@noalloc]
  external tan : float -> float = "frob_boxed_tan" "frob_tan" [@@unboxed] [@@noalloc]
  external asin : float -> float = "frob_boxed_asin" "frob_asin" [@@unboxed] [@@noalloc]
  external acos : float -> float = "frob_boxed_acos" "frob_acos" [@@unboxed] [@@noalloc]
  external atan : float -> float = "frob_boxed_atan" "frob_atan" [@@unboxed] [@@noalloc]
  external atan2 : float -> float -> float = "frob_boxed_atan2" "frob_atan2" [@@unboxed] [@@noalloc]
  external hypot : float -> float -> float = "frob_boxed_hypot" "frob_hypot" [@@unboxed] [@@noalloc]
end

module Single = struct
  external exp : float -> float = "frob_boxed_single_exp" "frob_single_exp" [@@unboxed] [@@noalloc]
  external log : float -> float = "frob_boxed_single_log" "frob_single_log" [@@unboxed] [@@noalloc]

  external pow : float -> float -> float = "frob_boxed_single_pow" "frob_single_pow"
  [@@unboxed] [@@noalloc]

  external sin : float -> float = "frob_boxed_single_sin" "frob_single_sin" [@@unboxed] [@@noalloc]
  external cos : float -> float = "frob_boxed_single_cos" "frob_single_cos" [@@unboxed] [@@noalloc]
  external tan : float -> float = "frob_boxed_single_tan" "frob_single_tan" [@@unboxed] [@@noalloc]

  external asin : float -> float = "frob_boxed_single_asin" "frob_single_asin"
  [@@unboxed] [@@noalloc]

  external acos : float -> float = "frob_boxed_single_acos" "frob_single_acos"
  [@@unboxed] [@@noalloc]

  external atan : float -> float = "frob_boxed_single_atan" "frob_single_atan"
  [@@unboxed] [@@noalloc]

  external atan2 : float -> float -> float = "frob_boxed_single_atan2" "frob_single_atan2"
  [@@unboxed] [@@noalloc]

  external hypot : float -> float -> float = "frob_boxed_single_hypot" "frob_single_hypot"
  [@@unboxed] [@@noalloc]
end

let of_precision : Basis.Real.t -> (module S) = function
  | Double -> (module Double)
  | Single -> (module Single)
