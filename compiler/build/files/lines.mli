(** Reads a text line by line, in bounded memory whatever the file contains. *)

type t

exception Too_long
(** A line of more than {!longest} bytes. *)

val longest : int
(** The same limit as for a row of a trace. *)

val of_channel : in_channel -> t
(** Reads ahead, so no other code may read from the channel. *)

val next : t -> string option
(** The next line without its line feed; [None] at the end. Raises [Too_long] or [Sys_error]. *)
