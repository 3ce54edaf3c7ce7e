(** The options of [frobc falsify]. *)

type t = {
  params : string list;  (** each [NAME=LOW to HIGH] *)
  inputs : string list;  (** each [NAME=LOW to HIGH] or [NAME=VALUE] *)
  disturbances : string list;
      (** each [TABLE.KEY=LOW to HIGH], for a key in a table of the world file *)
  seeds : string option;  (** [LOW to HIGH], the range of noise seeds *)
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
