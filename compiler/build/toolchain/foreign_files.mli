(** Selects the user's C files that a program is built with. *)

val checked :
  name:string -> sources:string list -> Cgen.Emit.t -> (Toolchain.foreign option, string) result
(** [checked ~name ~sources files] selects the files for the program [name]. [sources] are the files
    given with [--with], and [files] are the generated ones. The error names a header or a function
    that the command line does not allow ({!Foreign_headers}, {!Foreign_symbols}). [None] if the
    program needs no C besides the generated files. *)

val refused_headers : name:string -> Cgen.Emit.t -> string list
(** The headers that the program needs and that a command line without [--with] does not allow. *)
