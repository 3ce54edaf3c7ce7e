(** Equality and order of data, by its structure.

    Products compare their parts in order, arrays their elements; sums compare constructors in the
    order of their declaration, then payloads. All comes down to [==] and [<] of numbers, so with
    NaN inside, a product is neither equal to, less than nor greater than another whose other parts
    do not decide. *)

type position := Evaluator.position

val equal : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val less : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val less_equal : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val not_ : position -> Node.target -> Flow.Ir.atom -> Flow.Ir.atom
