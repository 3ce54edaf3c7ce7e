(** The machines of a program as a state diagram, for Graphviz ([dot]).

    A machine is a cluster, its modes are the states, named as in the program and with the line that
    they stand on; a point leads to the state that a machine starts in. An edge is a transition,
    with the signal function whose event it waits for as far as that is known; it is dashed if it
    may take no time, which is to happen at the first instant of the state it leaves. What an event
    from outside starts is left by [any]. A dotted line leads from a state to a machine that runs
    inside it. *)

val print : Format.formatter -> Flow.Ir.program -> unit
