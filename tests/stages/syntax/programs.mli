(** Texts for testing the parser. *)

val parse : string -> Basis.Diagnostic.t list * Syntax.Ir.program option
(** A returned program has passed the lint. *)

val codes : string -> string list
(** The codes of all diagnostics, in order of position. *)

val printed : Syntax.Ir.program -> string

val written : unit -> (string * string) list
(** The files of the library, of the examples and of this folder: paths and texts. *)
