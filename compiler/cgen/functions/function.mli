(** Generates the reset and step functions of a node. *)

val reset : Program_names.t -> int -> Ir.function_

val steps : Program_names.t -> int -> Ir.function_ list
(** One function, or two for the root in single precision: the step with dt in whole nanoseconds,
    and one with dt in seconds that calls it. *)
