(** The cost of checking a program's assertions: compares the program that checks them with the
    version without checks, which runs on the robot. *)

type t = {
  count : int;  (** number of assertions *)
  operations : int;  (** additional operations in a step *)
  share : float;  (** [operations] as a fraction of the operations without assertions *)
  bytes : int;  (** additional bytes of state *)
}

val of_programs : plain:Bounds.t -> watched:Bounds.t -> t
