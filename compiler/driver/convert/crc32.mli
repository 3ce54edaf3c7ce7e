(** The CRC-32 of ISO 3309, as zlib, PNG and MCAP have it. *)

val update : int -> string -> int
(** Of what came before, by its CRC ([0] of nothing), and this text after it. *)
