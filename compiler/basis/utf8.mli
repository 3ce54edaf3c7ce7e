(** Well-formed UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF. *)

val decode : string -> int -> int * int
(** [decode text i]: how many bytes the character takes that starts at offset [i], and its code;
    [(0, 0)] if none well-formed starts there. *)

val first_error : string -> int option
(** The offset of the first byte that is not part of a well-formed character. *)

val is_continuation : char -> bool
(** Not the first byte of a character. *)
