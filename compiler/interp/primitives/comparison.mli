(** Equality and order of data, by its structure.

    Tuples and the fields of a constructor are compared from first to last; constructors in the
    order of their declaration; [False] comes before [True]. Numbers compare as IEEE says, so with
    NaN inside, data whose other parts do not decide is neither equal, less nor greater. *)

val equal : Value.t -> Value.t -> bool
val less : Value.t -> Value.t -> bool
val less_equal : Value.t -> Value.t -> bool
