(** Well-formed UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF. *)

val decode : string -> int -> int * int
(** [decode text i] is the length in bytes and the code point of the character at offset [i];
    [(0, 0)] if there is no well-formed character. *)

val first_error : string -> int option
(** The offset of the first byte that is not part of a well-formed character. *)

val is_continuation : char -> bool
(** Is this a continuation byte, that is, not the first byte of a character? *)
