(** The server's capabilities, as it announces them to the editor. *)

val all : encoding:string -> Basis.Json.t
