(** What an equation's right side reads. *)

val of_instance : (Ir.atom -> Ir.atom) -> (Ir.signal -> Ir.signal) -> Ir.instance -> Ir.instance
(** With other atoms read, and other signals defined. *)

val all : Ir.rhs -> Ir.atom list
(** All of them, in the order written in {!Ir}; of a [Delay], [init] comes first. *)

val same_instant : Ir.rhs -> Ir.atom list
(** Those whose value of the same instant is needed: not the arguments of [Delay] (whose [init] is
    static and read at the start only) and of [Integral]. *)

val map : (Ir.atom -> Ir.atom) -> Ir.rhs -> Ir.rhs
(** In the order of {!all}. The same right side, physically, if each operand is mapped to itself,
    physically. *)

val signals : Ir.atom list -> Ir.signal list
(** Without the constants. *)

val ty : Ir.atom -> Ir.ty

type key = Signal of int | Bool of bool | Int of int32 | Float of int64

val key : Ir.atom -> key
(** Of tables: a signal by its id, a Float by its bits, since there are two zeros, and a NaN is the
    same as itself. *)

val same : Ir.atom -> Ir.atom -> bool
(** The same {!key}. *)
