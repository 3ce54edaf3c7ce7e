(** A source line as a terminal displays it.

    Tabs become four spaces. Control characters and invalid UTF-8 become [U+FFFD], so that a file
    cannot send commands to the terminal. *)

type t

val of_line : string -> t
val width : t -> int

val column : t -> int -> int
(** The terminal column, from 0, of this byte offset in the line. Each offset past the end adds one
    column. *)

val characters_before : string -> int -> int
(** The number of characters before this byte offset in a line, not counting a byte order mark. *)

val part : t -> from:int -> width:int -> string
(** The part of the line that occupies [width] columns, starting at column [from]. *)
