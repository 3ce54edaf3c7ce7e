(** Core, as it says: by demand.

    In an instant the equations of a proc are values on demand that may need each other in any
    order; its instances are begun with their inputs on demand, and the states change only when the
    instant ends. So the order of equations has no meaning here either, and every instance runs at
    every instant, whether its output is needed or not. *)

type program

val program : ?params:(Core.Ir.Global.t * Value.thunk) list -> Core.Ir.program -> program
(** [params]: what these definitions are instead of what they say. *)

val definition : program -> Core.Ir.Global.t -> Value.thunk
(** The value of a definition without parameters. *)
