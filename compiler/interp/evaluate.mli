(** Evaluates Core lazily, as its definition specifies.

    Within an instant, the equations of a proc are thunks that may force each other in any order.
    Its instances receive their inputs as thunks, too, and change their state only at the end of the
    instant. Therefore the order of the equations does not matter. Every instance runs in every
    instant, even if its output is not needed. *)

type program

val program : ?params:(Core.Ir.Global.t * Value.thunk) list -> Core.Ir.program -> program
(** [params]: definitions whose values are overridden, each with its new value. *)

val definition : program -> Core.Ir.Global.t -> Value.thunk
(** The value of a definition without parameters. *)

val written : program -> Core.Ir.Global.t -> Value.thunk
(** Like {!definition}, but evaluates the right-hand side of the definition even if [params]
    replaces its value. *)
