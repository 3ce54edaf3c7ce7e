(** What an equation's right side reads. *)

val all : Ir.rhs -> Ir.atom list
(** All of them, in the order written in {!Ir}; of a [Delay], [init] comes
    first. *)

val fold : ('a -> Ir.atom -> 'a) -> 'a -> Ir.rhs -> 'a
(** Over {!all}, in that order, without making the list. *)

val same_instant : Ir.rhs -> Ir.atom list
(** Those whose value of the same instant is needed: not the arguments of
    [Delay] (whose [init] is static and read at the start only) and of
    [Integral]. *)

val map : (Ir.atom -> Ir.atom) -> Ir.rhs -> Ir.rhs
(** In the order of {!all}. The same right side, physically, if each operand is mapped
    to itself, physically. *)

val signals : Ir.atom list -> Ir.signal list
(** Without the constants. *)

val same : Ir.atom -> Ir.atom -> bool
(** The same signal or constant; Floats bit for bit, since there are two zeros, and a
    NaN is the same as itself. *)
