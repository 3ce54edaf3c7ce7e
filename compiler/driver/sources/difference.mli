(** Two texts line by line, as [diff -u] shows them. *)

val unified : name:string -> string -> string -> string
(** [unified ~name before after] with three lines of context; [""] if they are equal. *)
