(** Random decisions. *)

val chance : Random.State.t -> int -> bool
(** True with probability 1 / n. *)

val one_of : Random.State.t -> 'a list -> 'a
(** An element of a nonempty list. *)

val weighted : Random.State.t -> (int * 'a) list -> 'a
(** An element chosen with probability proportional to its weight; at least one weight must be
    positive. *)

val shuffled : Random.State.t -> 'a list -> 'a list
