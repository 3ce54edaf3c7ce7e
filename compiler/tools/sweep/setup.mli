(** Prepares a sweep and reports errors before its first run. *)

type place = {
  world : string;  (** the world's name in the plan *)
  path : string;
  robot : string;  (** empty if only the program determines it *)
  program : string;  (** path of the program compiled for hosts; [judge]: path of the judge *)
  judge : string;
  digest : string;
      (** digest of everything that a run here depends on, except the seed and the parameters *)
}
(** A world and a robot, with the program and the judge compiled for them. *)

type t = {
  plan : Plan.t;
  label : string;  (** label of the trial *)
  lasts : float;  (** s *)
  rate : float;  (** Hz *)
  first : int;
  last : int;  (** first and last seed *)
  places : place array;
  axes : Points.axis list;
  points : string array array;
  measures : Measures.t list;
}

val of_plan : Common_options.t -> sources:string list -> string -> (t, int) result
(** Reads a plan file. Errors are reported with their place in the plan; the result is then the exit
    status. Each place is tried for one instant, so that the sweep does not start if a run is
    impossible. *)
