(** Hints about signatures and types. *)

val with_parameters : Found.rule
(** [vector<float>], as in C++. *)

val unit_without_brackets : Found.rule
(** [Float m/s]. *)

val in_another_notation : Found.rule
(** [event float], with a lower-case letter, or [float[]]. *)

val contexts : Found.rule
(** Two contexts with a [=>] each, as in Haskell. *)

val split_arrow : Found.rule
(** [Float - > Float], with a space inside the arrow. *)

val parameters : Found.rule
(** [f :: Float, Float -> Float], with a comma instead of an arrow. *)

val capital : Found.rule
(** A value name that begins with a capital letter. *)

val pointer : Found.rule
(** A pointer in the type of a foreign function. *)

val size : Found.rule
(** A computed array size. *)

val misplaced : Found.t -> string
(** The hint for a [::] where neither a signature nor an annotation is allowed. *)

val list : Found.rule
(** The type of a list, as in `type Row = [Distance]`. *)
