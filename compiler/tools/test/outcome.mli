(** The results of tests. *)

type fate =
  | Held
  | Violated
  | Undecided  (** an obligation was still open at the end *)
  | Unasked  (** no condition ever applied *)
  | Void  (** an assumption failed, so the run proves nothing *)

type collision = {
  time : float;  (** s *)
  x : float;  (** in m, in world coordinates *)
  y : float;
  clearance : float;  (** in m, measured from the robot's centre at that time *)
  with_ : string;  (** for display, for example [the wall (room.toml, line 12)] *)
}
(** The beginning of a collision, when the robot first touches an object. *)

type run = {
  seed : int option;
  fate : fate;
  at : float;  (** seconds *)
  by : string;  (** the label of the failed assertion; [judge] if the judge itself failed *)
  truth : float list;  (** x, y, heading, clearance, touches, driven, odometry error *)
  collisions : int;  (** number of the robot's collisions; 0 for a test without a robot *)
  first : collision option;  (** the first of these collisions *)
  measured : (string * float) list;  (** final values, by {!Measures.t.probe} *)
}

type look = {
  around : string list;  (** lines with the program's outputs at the last two instants *)
  picture : string;  (** path of the picture; empty if there is none *)
  view : string;  (** command that shows the run; empty if there is none *)
}
(** Files and lines that illustrate a run. *)

type simpler = {
  needs : string list;  (** the remaining disturbances *)
  world : string;  (** path of a world file that contains only [needs] *)
  again : run;
  seen : look;
}
(** A run that fails in the same way with fewer of the world's disturbances. *)

type evidence = {
  run : run;
  look : look;  (** files and lines about [run] *)
  simpler : simpler option;
  note : string;  (** reason why something could not be saved; empty if there is none *)
}
(** The report about a failed run. *)

type t = {
  file : string;
  label : string;
  lasts : float;
  measures : Measures.t list;
  chance : Chance.t option;
  note : string;  (** additional remark; empty if there is none *)
  result : (run list, string) result;  (** if the test could not be run, the error is the reason *)
  evidence : evidence option;
}

type skipped = {
  path : string;  (** path of its program *)
  name : string;  (** label of the test *)
  what : string;  (** the missing requirement *)
  command : string;  (** the command that runs the test *)
}
(** A test that was skipped because its requirements must be given on the command line. *)
