(** What the standard library's [List] does only on the stack, in the OCaml versions before 5.1: for
    lists as long as a program. *)

val map : ('a -> 'b) -> 'a list -> 'b list
(** From first to last. *)

val split_at : int -> 'a list -> 'a list * 'a list
(** The first so many, and the others. *)

val map_sharing : ('a -> 'a) -> 'a list -> 'a list
(** As [map]. The same list, physically, if each element is mapped to itself, physically; then it
    takes no memory. *)
