(** Division of Ints as the language has it (language reference, section 4), for stages that compute
    with constants. The interpreter, which judges them, has its own. *)

val div : int32 -> int32 -> int32
(** Rounds to minus infinity; by 0 it is 0. *)

val mod_ : int32 -> int32 -> int32
(** What [div] leaves over, so with the sign of the divisor; by 0 it is 0. *)
