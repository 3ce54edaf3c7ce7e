(** Caches values computed from the texts of files. After each change to a program, the server needs
    the same files again, most of them unchanged. *)

type 'a t

val create : unit -> 'a t

val find : 'a t -> path:string -> string -> ('a option -> 'a) -> 'a
(** The value for this text of the file. If the text has changed, computes the value by calling the
    function with the value for the previous text, if there is one. *)
