(** [frobc falsify]: a run in which an assertion does not hold.

    The search is Python's, where the libraries for such searches are, and where all instants of a
    run are at hand: the Python package compiles the program by this very frobc, with
    [--asserts=margin], loads it, and runs it in memory. Here it is only found and started. *)

type search = {
  params : string list;  (** [NAME=LOW to HIGH] each *)
  inputs : string list;  (** likewise, or [NAME=VALUE] *)
  disturbances : string list;  (** [TABLE.KEY=LOW to HIGH] each, of the world file *)
  seeds : string option;  (** [LOW to HIGH], of its noise *)
  world : string option;
  duration : float;  (** s *)
  rate : float;  (** instants a second *)
  check_rate : float option;
  points : int;
  linear : bool;
  only : string list;  (** labels; all if none *)
  runs : int;
  seed : int;
  method_ : string;  (** [cma] or [random] *)
  keep : string;
}

val run : General.t -> entry:string -> sources:string list -> search -> string -> int
(** Goes on as the search; {!Exit_status.rejected} if it finds something. *)
