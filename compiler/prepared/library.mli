(** The modules of the library, parsed when the compiler was built. Nearly every program is shorter
    than the modules that it imports, so parsing these modules would take much of the time needed to
    compile a short program.

    Only the trees are stored. The results of later stages depend on all modules of a program, which
    determine the numbers of names and type variables and the visible instances. Therefore these
    stages run for each program. *)

val tree : file:string -> string -> Syntax.Ir.program option
(** The tree of a module, equal to the result of {!Syntax.Parse.program} for this file and text,
    which causes no diagnostics. [None] unless the file and text are identical to those of a library
    module when the compiler was built. Each call creates a new tree. *)
