(** The commands about robots behind a serial line: simulated ones, and programs
    that drive real ones. Each gives the exit status, as {!Commands} do. *)

type serve = {
  world : string option;
  seed : int;
  tcp : int option;  (** a port of this machine, instead of a pseudo-terminal *)
  duration : float option;  (** s; until it is ended otherwise *)
  model : string option;  (** of the robot *)
  log : string option;  (** file for the commands that arrive *)
  link : string option;  (** symbolic link to be kept to the device *)
}

val serve : robot:string option -> serve -> int
(** Becomes the simulated robot. *)
