(** Reads a file line by line, in bounded memory whatever the file contains. *)

type t

exception Too_long
(** A line is longer than {!longest} bytes. *)

val longest : int
(** Maximum length of a line, in bytes. Rows of traces have the same limit. *)

val of_channel : in_channel -> t
(** Reads ahead, so no other code may read from the channel. *)

val next : t -> string option
(** The next line without its line feed; [None] at the end. Raises [Too_long] or [Sys_error]. *)
