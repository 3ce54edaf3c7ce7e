(** Rows of a CSV file, as in RFC 4180 (LF or CRLF; a byte-order mark at the start is skipped). *)

type t

val reader : (unit -> char option) -> t
(** Of the characters that the function gives, [None] at the end. It may raise [Sys_error]. *)

type cell = { column : int;  (** of its first character, from 1 *) text : string }
type row = { line : int;  (** on which it starts, from 1 *) cells : cell list }

type problem =
  | Unreadable of string  (** the system's reason *)
  | Unclosed_quote
  | Late_quote  (** the last cell has blanks before its quote *)
  | Zero_byte

val next : t -> (row option, row * problem) result
(** The next row that is not an empty line; [None] at the end. With a problem, what was read of the
    row. *)

val line : t -> int
(** Of the next character. *)
