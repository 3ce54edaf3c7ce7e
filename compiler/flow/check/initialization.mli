(** Checks that everything a node needs to start is known when it starts.

    A signal is static if it depends only on the node's static parameters and on constants, through
    operations and functions. The initial value of a delay and the static arguments of an instance
    must be static. The levels of the source language guarantee this, so this check is a lint and
    never reports anything to the user. *)

val check : Ir.program -> unit
(** The program must be causal. Raises {!Basis.Diagnostic.Bug}. *)
