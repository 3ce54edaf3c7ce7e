(** The CRC-32 of ISO 3309, as used by zlib, PNG and MCAP. *)

val update : int -> string -> int
(** [update crc text] extends the CRC of the data before ([0] for none) by [text]. *)
