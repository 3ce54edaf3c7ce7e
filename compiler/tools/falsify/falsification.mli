(** [frobc falsify]: searches for a run that violates an assertion.

    The search is in Python, where the libraries for it are available and all instants of a run are
    in memory. The Python package compiles the program by calling this frobc with
    [--asserts=margin], loads it, and runs it. This module only finds and starts the package. *)

type search = {
  params : string list;  (** each [NAME=LOW to HIGH] *)
  inputs : string list;  (** each [NAME=LOW to HIGH] or [NAME=VALUE] *)
  disturbances : string list;  (** each [TABLE.KEY=LOW to HIGH], with a key of the world file *)
  seeds : string option;  (** [LOW to HIGH], range of the seeds for noise *)
  world : string option;
  duration : float;  (** s *)
  rate : float;  (** instants per second *)
  check_rate : float option;
  points : int;
  linear : bool;
  only : string list;  (** labels of assertions; empty for all *)
  runs : int;
  seed : int;
  method_ : string;  (** [cma] or [random] *)
  keep : string;
}

val run : Common_options.t -> entry:string -> sources:string list -> search -> string -> int
(** Replaces this process with the search, which exits with {!Exit_status.rejected} if it finds a
    violation. *)
