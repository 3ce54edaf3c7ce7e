(** Who reads the seconds since the instant before. *)

val by_one_mode : Ir.program -> Ir.node -> bool
(** Only one of several modes of the node's machine, and nothing else: they need
    computing only where that mode is stepped. A machine with instants of its
    own, whose time is not the node's, does not count. *)
