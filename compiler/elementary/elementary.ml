external exp : float -> float = "frob_boxed_exp" "frob_exp"
[@@unboxed] [@@noalloc]

external log : float -> float = "frob_boxed_log" "frob_log"
[@@unboxed] [@@noalloc]

external pow : float -> float -> float = "frob_boxed_pow" "frob_pow"
[@@unboxed] [@@noalloc]

external sin : float -> float = "frob_boxed_sin" "frob_sin"
[@@unboxed] [@@noalloc]

external cos : float -> float = "frob_boxed_cos" "frob_cos"
[@@unboxed] [@@noalloc]

external tan : float -> float = "frob_boxed_tan" "frob_tan"
[@@unboxed] [@@noalloc]

external asin : float -> float = "frob_boxed_asin" "frob_asin"
[@@unboxed] [@@noalloc]

external acos : float -> float = "frob_boxed_acos" "frob_acos"
[@@unboxed] [@@noalloc]

external atan : float -> float = "frob_boxed_atan" "frob_atan"
[@@unboxed] [@@noalloc]

external atan2 : float -> float -> float = "frob_boxed_atan2" "frob_atan2"
[@@unboxed] [@@noalloc]

external hypot : float -> float -> float = "frob_boxed_hypot" "frob_hypot"
[@@unboxed] [@@noalloc]
