(** Compares two texts line by line, in the format of [diff -u]. *)

val unified : name:string -> string -> string -> string
(** [unified ~name before after] is the difference, with three lines of context; [""] if the texts
    are equal. *)
