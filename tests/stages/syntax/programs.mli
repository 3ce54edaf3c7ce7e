(** Texts to try the parser on. *)

val parse : string -> Basis.Diagnostic.t list * Syntax.Ir.program option
(** What comes out has passed the lint. *)

val codes : string -> string list
(** Of everything reported, by place. *)

val printed : Syntax.Ir.program -> string

val written : unit -> (string * string) list
(** The library, the example and the programs beside this file: path and text. *)

val read : string -> string

val files_of : string -> string -> string list
(** [files_of directory suffix]: paths, sorted. *)
