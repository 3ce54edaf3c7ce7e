(** Well-formed UTF-8. *)

val first_error : string -> int option
(** The offset of the first byte that is not part of a well-formed character:
    no overlong forms, no surrogates, nothing beyond U+10FFFF. *)

val length_at : string -> int -> int
(** How many bytes the character takes that starts at this offset of a
    well-formed text. *)

val is_continuation : char -> bool
(** Not the first byte of a character. *)
