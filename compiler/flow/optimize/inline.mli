(** Instances replaced by the equations of their node.

    (a) Where that is necessary: an instance whose output feeds back to an input that the output
    does not need in the same instant cannot run as one call. A machine is stepped on trial instead.
    Expects a causal program; afterwards {!Schedule.of_node} succeeds on every node. (b) Where the
    node is so small that reading it in place is easier than a call. All others stay functions of
    their own, so one definition gives one C function, however often it is used.

    Names are kept, those of the node's inside with the instance's name in front where they would
    clash; spans stay where the programmer wrote. *)

val to_look_at : most:int -> Ir.program -> Ir.program
(** Every instance expanded whose node has at most so many equations then, loops and machines aside:
    not to be compiled, but for what can be said of it. Nodes keep their numbers, and transitions
    their order. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there was nothing to inline. *)

val uses : Ir.program -> int array
(** By node: how many instances run it. *)
