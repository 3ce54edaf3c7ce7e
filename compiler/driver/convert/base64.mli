(** Bytes as text (RFC 4648, with padding). *)

val encode : Buffer.t -> string -> unit
val decode : string -> string option
