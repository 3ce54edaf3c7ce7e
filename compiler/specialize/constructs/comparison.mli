(** Structural equality and ordering of data.

    Products are compared part by part, and arrays element by element. Sums are compared by
    constructor, in declaration order, then by payload. Everything reduces to [==] and [<] on
    numbers. Therefore a product that contains NaN is not equal to, less than or greater than
    another product, unless another component determines the result. *)

type position := Evaluator.position

val equal : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val less : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val less_equal : position -> Node.target -> Core.Ir.ty -> Value.t -> Value.t -> Flow.Ir.atom
val not_ : position -> Node.target -> Flow.Ir.atom -> Flow.Ir.atom
