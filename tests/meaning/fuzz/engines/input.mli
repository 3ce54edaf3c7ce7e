(** Random recordings for a program's input. *)

type kind =
  | Tame  (** numbers of the kind that programs usually meet in practice *)
  | Wild  (** many NaN, infinities and extreme numbers *)

val make : Random.State.t -> kind -> Interp.Shape.t -> rows:int -> Recording.t
(** Steps have all lengths, including 0. *)

val with_dt : Random.State.t -> Basis.Real.t -> Interp.Shape.t -> rows:int -> Recording.t
(** Tame values, each with a dt of this precision: common periods and values close to them, halves
    of nanoseconds, and sometimes any number. One recording in six reaches the largest possible
    time. *)
