(** Random recordings for a program's input. *)

type kind =
  | Tame  (** numbers such as programs meet *)
  | Wild  (** many NaN, infinities and extreme numbers *)

val make : Random.State.t -> kind -> Interp.Shape.t -> rows:int -> Recording.t
(** Steps are of all lengths, also 0. *)

val with_dt : Random.State.t -> Basis.Real.t -> Interp.Shape.t -> rows:int -> Recording.t
(** Tame values, each with a dt of this precision: common periods and what lies beside them, halves
    of nanoseconds, and now and then anything else. *)
