(** Selects the user's C files that a program is built with. *)

val checked :
  name:string -> sources:string list -> Cgen.Emit.t -> (Toolchain.foreign option, string) result
(** [checked ~name ~sources files]: [sources] are the files given with [--with], for the generated
    [files] of the program [name]. The error names a header or a function that the command line does
    not allow ({!Foreign_headers}, {!Foreign_symbols}). [None] if the program needs no C besides the
    generated files. *)

val refused_headers : name:string -> Cgen.Emit.t -> string list
(** The headers that need [--with] if the command line has no such option. *)
