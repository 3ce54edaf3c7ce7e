(** List functions that do not overflow the stack, for lists that grow with the size of the program.
    Before OCaml 5.1, the functions of the standard library are not tail-recursive. *)

val map : ('a -> 'b) -> 'a list -> 'b list
(** Visits the elements from first to last. *)

val map2 : ('a -> 'b -> 'c) -> 'a list -> 'b list -> 'c list
(** Visits the elements from first to last.

    @raise Invalid_argument if the lengths differ *)

val split_at : int -> 'a list -> 'a list * 'a list
(** Splits the list after its first [n] elements. *)

val map_sharing : ('a -> 'a) -> 'a list -> 'a list
(** Like {!map}, but if the function returns every element physically unchanged, returns the same
    list and allocates nothing. *)
