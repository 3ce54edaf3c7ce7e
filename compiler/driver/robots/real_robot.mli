(** The commands about robots behind a serial line: simulated ones, and programs that drive real
    ones. Each gives the exit status, as {!Commands} do. *)

type serve = {
  world : string option;
  seed : int;
  tcp : int option;  (** a port of this machine, instead of a pseudo-terminal *)
  camera : int option;  (** a port of this machine, for the cameras of the world *)
  duration : float option;  (** s; until it is ended otherwise *)
  model : string option;  (** of the robot *)
  log : string option;  (** file for the commands that arrive *)
  link : string option;  (** symbolic link to be kept to the device *)
}

val serve : robot:string option -> sources:string list -> serve -> int
(** Becomes the simulated robot. [sources] are the C files of a user's own one. *)

type run = {
  device : string;  (** a serial line, or [tcp:HOST:PORT] *)
  duration : float option;  (** s; until it is ended otherwise *)
  rate : float;  (** Hz *)
  record : string option;
  patience : float option;  (** s *)
  reconnect : float option;  (** s *)
  settings : string list;  (** of the driver, [NAME=VALUE], or of a camera, [LABEL.NAME=VALUE] *)
  cameras : string list;  (** where their frames come from: [SOURCE], or [LABEL=SOURCE] *)
  priority : int option;
  lock_memory : bool;
  exit_when_done : bool;  (** when the program's task has ended *)
  console : bool;
  look : Viewing.look option;  (** how it is shown while it goes on *)
}

val run :
  General.t -> entry:string -> sources:string list -> simulated:string list -> run -> string -> int
(** Becomes the program that drives the robot. [simulated]: options that were given but make sense
    in the simulator only. *)

val build :
  General.t ->
  entry:string ->
  sources:string list ->
  target:string ->
  output:string option ->
  string ->
  int
(** Writes that program, for a {!Target}. [sources] are the user's own C files. *)

val library :
  General.t -> entry:string -> sources:string list -> output:string option -> string -> int
(** Writes the program, for a robot or not, as a shared object for hosts of this machine, which find
    its table there ([frob/program.h]), and the function that takes many steps. *)
