(** Generates the step of a node implemented by the user's C: converts the node's leaves to the
    arguments that {!Foreign_interface} describes, calls the function, and converts the result back.

    A foreign value may be a null pointer if the program computes a value that it does not use, for
    example for an event that did not occur. A C function never receives a null pointer; it is not
    called in that case. *)

val step : Program_names.t -> int -> Foreign_interface.t -> Ir.function_
