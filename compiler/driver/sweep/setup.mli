(** All that a sweep needs before its first run, and what can be wrong with it. *)

type place = {
  world : string;  (** as the plan says *)
  path : string;
  robot : string;  (** empty if only the program knows *)
  program : string;  (** for hosts; so is the judge *)
  judge : string;
  digest : string;  (** of all that a run here depends on, beside seed and parameters *)
}
(** A world with a robot in it, and the program and the judge for them. *)

type t = {
  plan : Plan.t;
  label : string;  (** of the trial *)
  lasts : float;  (** s *)
  rate : float;  (** Hz *)
  first : int;
  last : int;  (** seeds *)
  places : place array;
  axes : Points.axis list;
  points : string array array;
  measures : Measures.t list;
}

val of_plan : General.t -> sources:string list -> string -> (t, int) result
(** Of the file of a plan. The error is the exit status; what is wrong has been told, with the place
    in the plan. Each place is tried for an instant, so that no run is made if one cannot be. *)
