(** Numbers of bytes and of operations.

    Twenty definitions that each use the one before twice have a million instances; a few more and
    machine integers would wrap around. So amounts stop at {!most}, which no memory holds and no
    step reaches. *)

val most : int
val add : int -> int -> int
val times : int -> int -> int

val round_up : int -> alignment:int -> int
(** To the next multiple. *)
