(** The operands on the right-hand sides of equations. *)

val of_instance : (Ir.atom -> Ir.atom) -> (Ir.signal -> Ir.signal) -> Ir.instance -> Ir.instance
(** Replaces the atoms that an instance reads and the signals that it defines. *)

val all : Ir.rhs -> Ir.atom list
(** All operands, in the order of {!Ir}; for a [Delay], [init] comes first. *)

val same_instant : Ir.rhs -> Ir.atom list
(** The operands whose values are needed in the same instant. Excludes the operands of [Delay]
    (whose [init] is static and only read at the start) and of [Integral]. *)

val map : (Ir.atom -> Ir.atom) -> Ir.rhs -> Ir.rhs
(** Maps the operands in the order of {!all}. If all new operands are physically equal to the old
    ones, so is the right-hand side. *)

val signals : Ir.atom list -> Ir.signal list
(** The signals among the atoms. *)

val ty : Ir.atom -> Ir.ty

type key = Signal of int | Bool of bool | Int of int32 | Float of int64

val key : Ir.atom -> key
(** A key for tables: signals by id, and Floats by their bits, so that the two zeros are different
    and a NaN equals itself. *)

val same : Ir.atom -> Ir.atom -> bool
(** Whether two atoms have the same {!key}. *)
