(** Test files.

    The tests and trials of a program [NAME.frob] may be in a separate file [NAME.test.frob] in the
    same folder. A test file is checked as if it were the end of the program's module: it can use
    all definitions and imports of the program, and may have further imports. The compiler treats it
    as a second module that no module imports. A program therefore cannot depend on its tests, and
    is compiled without reading them. *)

val path : string -> string
(** The test file of a program: [bug.test.frob] for [bug.frob]. *)

val program : string -> string option
(** The program of a test file: [bug.frob] for [bug.test.frob]. [None] for other files. *)

val program_or_self : string -> string
(** The program of a test file. Returns any other file unchanged. *)

val module_ : string -> string
(** Turns the name of a program's module into the name of its test module, which cannot occur in
    source code. *)

val is_module_of : string -> main:string -> bool
(** Is this the module [main], or the program that [main] tests? *)
