(** The server's capabilities, in the form in which it announces them to the editor. *)

val all : encoding:string -> Basis.Json.t
