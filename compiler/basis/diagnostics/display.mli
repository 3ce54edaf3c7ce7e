(** A line of source as a terminal shows it.

    Tabs become four blanks; control characters and bytes that are no UTF-8 become [U+FFFD], so that
    a file cannot send commands to the terminal. *)

type t

val of_line : string -> t
val width : t -> int

val column : t -> int -> int
(** The terminal column, from 0, at which this byte offset of the line is shown; offsets past the
    end go on at one column each. *)

val characters_before : string -> int -> int
(** How many characters stand before this byte offset of a line; a byte order mark is none. *)

val part : t -> from:int -> width:int -> string
(** What is shown in [width] columns from column [from] on. *)
