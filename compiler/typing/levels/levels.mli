(** Levels: what is known when, and where instances may stand (language reference, section 2).

    An instance runs at every instant of its proc. In a branch, a guard or a function it may stand
    if that makes no difference: what is run remembers nothing ({!Memory}), and mentions nothing
    that has a value only there.

    Takes an inferred program and fills in the level of each binding. Reports what is run without
    being static ([E0340]), other misplaced instances ({!Misplaced}), signal functions bound but not
    static ([E0344]), and recursive lets ([E0346]). Each message shows the chain of equations that
    makes the variable a signal. What a proc inside a proc mentions of the one around it is captured
    at the instant at which it is made.

    Method: {!Level_dependencies} builds the graph of what mentions what, {!Level_graph} solves it,
    and a second walk checks each place. Linear. *)

val program : ?sources:Basis.Source.t -> Basis.Diagnostic.sink -> Ir.program -> Ir.program
(** [sources]: what messages quote from. *)
