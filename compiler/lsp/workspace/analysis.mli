(** What the compiler knows of one text, as the main module of a program. *)

open Basis

type t = {
  path : string;  (** of the file, which may say something else or not be there *)
  text : Text.t;
  shown : string;  (** the name that spans in this text have *)
  tree : Syntax.Ir.program option;  (** [None] if it cannot be parsed *)
  diagnostics : Diagnostic.t list;
  sources : Source.t;  (** all texts that were read *)
  resolved : Resolve.Ir.program option;  (** [None] if names are wrong *)
  typed : Typing.Ir.program option;  (** [None] if types are *)
  fault : string option;  (** the compiler's own *)
}

val check :
  library:string ->
  read:(string -> (string, Resolve.Files.error) result) ->
  path:string ->
  string ->
  t
(** [read] has the texts of other modules. Raises nothing. *)

val partial : library:string -> read:(string -> (string, Resolve.Files.error) result) -> t -> t
(** Of a text with mistakes what can be understood: with the trees of what is right in it. *)

val path_of : library:string -> string -> string
(** Where the file is that spans call so. *)

val guarded : (unit -> 'a) -> ('a, string) result
(** Whatever the compiler does, this ends, with a value or with what went wrong; after some time it
    is given up. *)

val patience : float ref
(** That time, in seconds: half a minute. *)
