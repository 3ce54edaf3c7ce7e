(** Integer division as the language defines it (language reference, section 4), for compiler stages
    that evaluate constants. The interpreter has a separate implementation, because it is used to
    test those stages. *)

val div : int32 -> int32 -> int32
(** Rounds towards minus infinity. Returns 0 for a division by 0. *)

val mod_ : int32 -> int32 -> int32
(** The remainder of [div], which has the sign of the divisor; 0 for a division by 0. *)
