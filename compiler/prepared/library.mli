(** The library's modules, parsed when the compiler was built: nearly every program is shorter than
    what it imports, and reading that again takes much of the time of compiling a short one.

    Only trees are kept. What comes after parsing depends on which modules a program is made of (the
    numbers of names and type variables, the instances that are seen), so it is done for each
    program anew. *)

val tree : file:string -> string -> Syntax.Ir.program option
(** The tree of a module, equal to what {!Syntax.Parse.program} makes of that file and text, without
    a diagnostic; [None] if they are not, byte for byte, of the library that the compiler was built
    with. Each call makes a new tree. *)
