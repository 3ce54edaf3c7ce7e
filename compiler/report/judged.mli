(** The cost of checking a program's assertions: the difference between the version with checks and
    the version without, which runs on the robot. *)

type t = {
  count : int;  (** number of assertions *)
  operations : int;  (** operations that the checks add to a step *)
  share : float;  (** [operations], as a fraction of the operations without checks *)
  bytes : int;  (** bytes that the checks add to the state *)
}

val of_programs : plain:Bounds.t -> watched:Bounds.t -> t
