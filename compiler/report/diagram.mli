(** Prints the machines of a program as a state diagram for Graphviz ([dot]).

    A machine is a cluster. Its modes are the states, each labelled with its name and line in the
    program; a dot points to the initial state. An edge is a transition, labelled with the signal
    function that causes it, if that is known. The edge is dashed if the transition may take no
    time, that is, occur in the first instant of the state it leaves. Transitions caused by an event
    from outside start at [any]. A dotted line connects a state to a machine that runs inside it. *)

val print : Format.formatter -> name:string -> Machines.t list -> unit
