(** Structural equality and ordering of data.

    The components of a tuple and the fields of a constructor are compared from first to last.
    Constructors are ordered as in their declaration; [False] comes before [True]. Numbers compare
    as IEEE 754 defines. Therefore, if the order of two values depends on a NaN, neither is equal
    to, less than or greater than the other. *)

val equal : Value.t -> Value.t -> bool
val less : Value.t -> Value.t -> bool
val less_equal : Value.t -> Value.t -> bool
