(** Places of a text in an earlier or later version of it.

    Between one version and the next, what stands before the first difference and behind the last
    one is at corresponding places; what lies between them has none. *)

type step
type t = step list

val none : t

val between : string -> string -> t
(** [between from to_] *)

val and_then : t -> t -> t
(** The second begins with the text that the first ends with. *)

val back : t -> t
(** The other way round. *)

val offset : t -> int -> int option
(** Where this offset of the first text is in the last. *)

val place : t -> int * int -> (int * int) option
(** Of a piece of text that is the same in both. *)

val range : t -> int * int -> (int * int) option
(** Of a piece of text that is whole in both, or has differences inside. *)
