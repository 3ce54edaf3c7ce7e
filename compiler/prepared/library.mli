(** The modules of the library, parsed when the compiler was built. Nearly every program is shorter
    than the modules that it imports, so parsing these modules would take much of the time needed to
    compile a short program.

    Only the trees are stored. The results of later stages depend on all modules of a program,
    because these determine the ids of names and type variables and the set of visible instances.
    Therefore the later stages run for each program. *)

val tree : file:string -> string -> Syntax.Ir.program option
(** The tree that {!Syntax.Parse.program} would return for this file and text, without errors.
    [None] unless the file and text are identical to those of a library module when the compiler was
    built. Each call creates a new tree. *)
