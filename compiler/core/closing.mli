(** An open program, closed by the types of a robot. *)

val program : Ir.program -> Ir.definition -> suffix:string -> input:Ir.ty -> output:Ir.ty -> Ir.program * Ir.Global.t
(** Adds a definition that is the open one (of type [Program i o]) at these
    types, which it must allow; its name is the open one's with the suffix. *)
