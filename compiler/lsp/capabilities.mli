(** What the server can do, as it tells an editor. *)

val all : encoding:string -> Basis.Json.t
