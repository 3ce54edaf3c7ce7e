(** What the C files of a program are called. *)

val name : string -> string
(** [name "walls/follow it.frob"] is ["follow it"]: the file's name without folder and ending. What
    cannot stand in C's quotes, or is no character to be seen, becomes [_]. *)

val check : ?beside_c:bool -> string -> (unit, string) result
(** Whether the program of this file can have C files: not where [NAME.h] would stand before a
    header that they include, or that C of the user's may include where there is any ([beside_c]),
    or be too long a name for a file. *)
