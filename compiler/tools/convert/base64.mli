(** Base64 (RFC 4648, with padding). *)

val encode : Buffer.t -> string -> unit
val decode : string -> string option
