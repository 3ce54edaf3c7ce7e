(** What it costs to judge a program's assertions: the program with them beside the program without,
    as it is when it drives unwatched. *)

type t = {
  count : int;  (** of assertions *)
  operations : int;  (** more in a step *)
  share : float;  (** of those without *)
  bytes : int;  (** of state more *)
}

val of_programs : plain:Bounds.t -> watched:Bounds.t -> t
