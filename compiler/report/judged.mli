(** The cost of checking a program's assertions. It is the difference in cost between the program
    with checks and the version without checks, which runs on the robot. *)

type t = {
  count : int;  (** number of assertions *)
  operations : int;  (** operations that the checks add to a step *)
  share : float;  (** [operations], as a fraction of the operations without checks *)
  bytes : int;  (** bytes that the checks add to the state *)
}

val of_programs : plain:Bounds.t -> watched:Bounds.t -> t
