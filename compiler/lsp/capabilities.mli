(** The server's capabilities, as JSON for the reply to [initialize]. *)

val all : encoding:string -> Basis.Json.t
