(** Inlining: replaces instances with the equations of their nodes.

    An instance is inlined in two cases. (a) It is necessary: an instance cannot run as one call if
    one of its outputs feeds back to an input that the output does not need in the same instant. A
    machine gets a trial step instead. The program must be causal; afterwards {!Schedule.of_node}
    succeeds on every node.

    (b) The node is so small that reading it in place is easier than reading a call. All other nodes
    remain separate functions, so a definition becomes one C function, no matter how often it is
    used.

    Names are kept; names from inside the node are prefixed by the instance's name if they would
    clash. Spans refer to the original source. *)

val to_look_at : most:int -> Ir.program -> Ir.program
(** Inlines every instance whose node has at most [most] equations after inlining, except loops and
    machines. The result is for analysis only, not for compilation. Nodes keep their indices, and
    transitions their order. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if nothing was inlined. *)

val uses : Ir.program -> int array
(** For each node, the number of instances that run it. *)
