(** Hints about signatures and types. *)

val split_arrow : Found.rule
(** [Float - > Float]. *)

val parameters : Found.rule
(** [f :: Float, Float -> Float]. *)

val capital : Found.rule
(** The name of a value that begins with a capital. *)

val pointer : Found.rule
(** A pointer in the type of a foreign function. *)

val size : Found.rule
(** A size that is computed. *)
