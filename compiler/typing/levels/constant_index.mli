(** Evaluates the index of [!] at compile time: a number literal, a name defined as one, or
    [+ - * div mod min max] of such expressions. *)

type constants
(** The values of names, evaluated on demand. *)

val create : Ir.param list -> constants
val local : constants -> Ir.Local.t -> Ir.expr -> unit
val global : constants -> Ir.Global.t -> Ir.expr -> unit
val value : constants -> Ir.expr -> (int32, Level_fact.problem) result
