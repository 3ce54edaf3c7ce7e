(** Messages about characters, names, numbers, strings and comments that the lexer does not accept.
*)

open Basis

type colons
(** The topics of the hints given for colons so far. *)

val no_colons : colons

val diagnostic : text:string -> colons -> Syntax.Lexical_fact.t -> Diagnostic.t option * colons
(** [None] if the diagnostic for an earlier character explains this one. *)
