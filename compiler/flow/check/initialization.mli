(** Initialization: what a node needs to start is known when it starts.

    A signal is static if it depends on the node's statics and on constants only, through operations
    and functions. The initial value of a delay and the statics that are passed to a signal function
    must be. The levels of the source language promise it, so this is a lint: it has nothing to say
    to the programmer. *)

val check : Ir.program -> unit
(** For a causal program. Raises {!Basis.Diagnostic.Bug}. *)
