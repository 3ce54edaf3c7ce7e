(** Loads programs from memory, together with the standard library. *)

val load :
  ?main:string -> (string * string) list -> Basis.Diagnostic.t list * Resolve.Ir.program option
(** [load files] loads files given as paths and texts; the program is [main.frob]. A returned
    program has passed the lint. *)

val codes : Basis.Diagnostic.t list -> string list
