(** Levels: what is known when, and where instances may stand (language
    reference, section 2).

    Takes an inferred program and fills in the level of each binding. Reports
    what is run without being static ([E0340]), runs outside of procs
    ([E0341]), in branches ([E0342]) and in functions ([E0343]), signal
    functions bound but not static ([E0344]), and recursive lets ([E0346]).
    Each message shows the chain of equations that makes the variable a signal.
    What a proc inside a proc mentions of the one around it is captured at the
    instant at which it is made.

    Method: {!Level_dependencies} builds the graph of what mentions what,
    {!Level_graph} solves it, and a second walk checks each place. Linear. *)

val program : Basis.Diagnostic.sink -> Ir.program -> Ir.program
