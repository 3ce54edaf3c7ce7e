(** Programs in memory, with the standard library. *)

val load :
  ?main:string -> (string * string) list -> Basis.Diagnostic.t list * Resolve.Ir.program option
(** [load files]: paths and texts; the program is [main.frob]. A program that comes out has passed
    the lint. *)

val codes : Basis.Diagnostic.t list -> string list

val directory : string -> string list
(** The files of a directory, sorted. *)

val read : string -> string
