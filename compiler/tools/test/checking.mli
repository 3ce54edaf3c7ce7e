(** Functions for running a test. *)

val alone : Common_options.t -> sources:string list -> Resources.t -> Session.t
(** The session for commands that do not run tests. *)

val read : string -> string
(** The text of an existing file. *)

val beside : string -> string -> string
(** [beside file name] resolves the path [name] relative to the folder of [file]. *)

val compiled : Session.t -> Common_options.t -> entry:string -> string -> (string, string) result
(** Compiles a program for hosts and returns the path of the result. Reports compilation errors
    before it returns. *)

val measures : Session.t -> entry:string -> string -> (Measures.t list, string) result
(** [measures context ~entry file] returns the measures of the judge [entry] in the file. *)

val complaint : Workers.result -> string
(** The first line of a host's error message. *)

val quoted : string -> string
(** Quotes a word for a shell. *)

val program_words : Session.t -> string
(** The options that a printed command needs to compile the same program, each quoted and preceded
    by a space. *)

val test_again : Session.t -> string -> Checks.t -> string
(** [test_again context file check] is the command that repeats a test. *)

val kept : Session.t -> string -> Checks.t -> string -> string
(** [kept context file check ending] is the path, without its extension, of files about a failed run
    of a test: [keep], the slug of the label, and [ending]. If {!kept} has already assigned that
    name to another test, adds the program's name after the slug, and then, if necessary, a number.
*)
