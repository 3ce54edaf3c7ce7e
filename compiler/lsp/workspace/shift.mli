(** Places of a text in an earlier or later version of it.

    What stands before the first difference of the two and behind the last one is at corresponding
    places; what lies between them has none. *)

type t

val between : string -> string -> t
(** [between from to_] *)

val offset : t -> int -> int option
(** Where this offset of the first text is in the second. *)

val range : t -> int * int -> (int * int) option
(** Of a piece of text that is whole in both, or has the difference inside. *)
