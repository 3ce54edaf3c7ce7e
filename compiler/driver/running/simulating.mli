(** [frobc run] in the simulator. *)

type run = {
  world : string option;
  duration : float option;  (** s; a minute if [None], and without end if the run is shown *)
  rate : float;  (** Hz *)
  seed : int;
  realtime : bool;
  record : string option;
  picture : string option;
  strict : bool;
  exit_when_done : bool;  (** end when the program has ended *)
  console : bool;  (** keys typed on standard input are the program's *)
  look : Viewing.look option;
}

val run : General.t -> entry:string -> sources:string list -> run -> string -> int
