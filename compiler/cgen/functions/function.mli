(** Generates the reset and step functions of a node. *)

val reset : Program_names.t -> int -> Ir.function_

val steps : Program_names.t -> int -> Ir.function_ list
(** One function, or two for the root: the step, which takes dt in nanoseconds and in seconds, and a
    function that takes dt only in seconds and calls the step. *)
