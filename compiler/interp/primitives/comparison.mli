(** Structural equality and order of data.

    Compares tuples and the fields of a constructor from first to last, and constructors in the
    order of their declaration; [False] comes before [True]. Numbers compare as IEEE 754 defines.
    Therefore, if the order of two values depends on a NaN, neither is equal to, less than or
    greater than the other. *)

val equal : Value.t -> Value.t -> bool
val less : Value.t -> Value.t -> bool
val less_equal : Value.t -> Value.t -> bool
