(** A sweep that is ready to run. *)

type place = {
  world : string;  (** the world's name in the plan *)
  path : string;
  robot : string;  (** empty if the program alone determines the robot *)
  program : string;  (** path of the program compiled for hosts; [judge]: path of the judge *)
  judge : string;
  digest : string;
      (** digest of everything that a run with this world and robot depends on, except the seed and
          the parameters *)
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
