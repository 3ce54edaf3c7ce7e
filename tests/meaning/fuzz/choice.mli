(** Random decisions. *)

val chance : Random.State.t -> int -> bool
(** True one time in so many. *)

val one_of : Random.State.t -> 'a list -> 'a
(** Of a list that is not empty. *)

val weighted : Random.State.t -> (int * 'a) list -> 'a
(** Each with its weight; not all are 0. *)

val shuffled : Random.State.t -> 'a list -> 'a list
