(** Reads the rows of a CSV file (RFC 4180). Lines end with LF or CRLF; a byte-order mark at the
    start is skipped. *)

type t

val reader : ?separator:char -> (unit -> char option) -> t
(** Reads from a function that returns the next character, or [None] at the end of the file. The
    function may raise [Sys_error]. Cells are separated by commas, or by [separator]. *)

type cell = { column : int;  (** column of its first character, counted from 1 *) text : string }
type row = { line : int;  (** line on which the row starts, counted from 1 *) cells : cell list }

type problem =
  | Unreadable of string  (** the operating system's error message *)
  | Unclosed_quote
  | Late_quote
      (** a cell has whitespace before its opening quote; this cell is the last one in the part of
          the row that was read *)
  | Zero_byte
  | Too_long
      (** the row is larger than {!longest} bytes or has more than a million cells; these limits
          bound memory use *)

val longest : int

val next : t -> (row option, row * problem) result
(** The next row, skipping empty lines; [None] at the end. An error includes the part of the row
    that was read before the error. *)

val line : t -> int
(** Line number of the next character. *)
