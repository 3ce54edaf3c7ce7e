(** Checks which C functions a program may call. A program from somebody else must not be able to
    call functions of the C library such as [system] and [remove]. *)

val check : calls:string list -> string list -> (unit, string) result
(** Checks that each of these names is in {!Basis.C_names.pure}, is a kernel of the runtime
    ({!Kernels}), or is mentioned in one of these files, which the user has provided. The error
    lists the names that are not. *)

val unknown : calls:string list -> string list -> string list
(** The names for which {!check} reports an error. *)

val mentions : string -> string -> bool
(** [mentions text name] is true if the name occurs in the text as a separate word. *)

val giving : calls:string list -> string list -> string list
(** The C files that mention one of these names, ignoring the names of pure functions and kernels.
*)
