(** Who reads the seconds since the instant before. *)

val by_one_mode : Ir.program -> Ir.node -> bool
(** Only one of several modes of the node's machine, and nothing else: they need
    computing only where that mode is stepped. A machine with instants of its
    own, whose time is not the node's, does not count. *)

val nanoseconds_in_floats : Ir.program -> Ir.node -> bool
(** The root's nanoseconds stay the double that they are made as, for modes to make
    integers of them where they count in them: unless its machine has instants of its
    own, of which it adds up the time. Where Floats are of single
    precision the step is given integers. *)

val divides : Ir.program -> bool
(** Something is divided by them, as a derivative is: where they are made by a division
    too, one would wait for the other. *)
