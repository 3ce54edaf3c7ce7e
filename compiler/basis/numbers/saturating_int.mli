(** Integers that saturate instead of wrapping around, for counts of bytes and operations.

    If each of twenty definitions uses the previous one twice, there are a million instances; longer
    chains would overflow machine integers. Results therefore saturate at {!most}, which exceeds any
    real memory size or step count. *)

val most : int
val add : int -> int -> int
val times : int -> int -> int

val round_up : int -> alignment:int -> int
(** Rounds up to a multiple of the alignment. *)
