(** [frobc run] with the simulator. *)

type run = {
  world : string option;
  record : string option;
  picture : string option;
  look : Viewing.look option;  (** how the run is shown live *)
  host : string list;  (** additional arguments for the simulator *)
}

val run : Common_options.t -> entry:string -> sources:string list -> run -> string -> int
