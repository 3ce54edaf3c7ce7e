(** Values computed from the texts of files. After each change to a program, the same files are
    needed again, and most of them have not changed. *)

type 'a t

val create : unit -> 'a t

val find : 'a t -> path:string -> string -> ('a option -> 'a) -> 'a
(** The value for this text of the file. If the text has changed, calls the function to compute the
    value. Its argument is the value for the previous text, if there is one. *)
