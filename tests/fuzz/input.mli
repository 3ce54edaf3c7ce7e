(** Random recordings for a program's input. *)

type kind =
  | Tame  (** numbers such as programs meet *)
  | Wild  (** many NaN, infinities and extreme numbers *)

val make : Random.State.t -> kind -> Interp.Shape.t -> rows:int -> Recording.t
(** Steps are of all lengths, also 0. *)
