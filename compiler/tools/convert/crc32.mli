(** The CRC-32 of ISO 3309, as used by zlib, PNG and MCAP. *)

val update : int -> string -> int
(** [update crc text] extends [crc], the CRC of the preceding data ([0] if there is none), with
    [text]. *)
