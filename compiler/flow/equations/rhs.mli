(** What an equation's right side is; what it reads is in {!Operands}. *)

val is_stateful : Ir.rhs -> bool
(** It depends on instants before this one, or on when its node was started; every other one is a
    function of its operands at the same instant. *)
