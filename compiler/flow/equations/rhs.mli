(** Properties of the right-hand sides of equations; {!Operands} lists their operands. *)

val is_stateful : Ir.rhs -> bool
(** Whether the value depends on earlier instants or on the start of the node. Otherwise it is a
    function of its operands in the same instant. *)
