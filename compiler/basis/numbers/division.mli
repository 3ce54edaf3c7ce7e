(** Integer division as the language defines it (language reference, section 4), for compiler stages
    that evaluate constants. The interpreter, against which they are tested, has its own
    implementation. *)

val div : int32 -> int32 -> int32
(** Rounds towards minus infinity. Division by 0 gives 0. *)

val mod_ : int32 -> int32 -> int32
(** The remainder of [div], which has the sign of the divisor. The remainder of a division by 0 is
    0. *)
