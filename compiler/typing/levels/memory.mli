(** Finds the stateful signal functions, whose output depends on when they started.

    A stateless one produces the same output whether it runs at every instant or only when its value
    is needed, so its place in the program does not matter. Sensor methods count as stateless: a
    method of type [SF i …] in a class of [i] reports the robot's current readings. *)

type t

val create : Ir.program -> t

val local : t -> Ir.binding -> unit
(** Records a local binding of a signal function, which procs may run. *)

val remembers : t -> Ir.expr -> bool
(** Is this signal function stateful when it has all its arguments? If this is unknown, returns
    [true]. *)
