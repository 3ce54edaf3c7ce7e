(** What became of tests: for people, for tools, for a CI server. *)

type fate =
  | Held
  | Violated
  | Undecided  (** something is still waited for at the end *)
  | Unasked  (** nothing was to hold at any instant *)
  | Void  (** an assumption failed, so it says nothing *)

type run = {
  seed : int option;
  fate : fate;
  at : float;  (** seconds *)
  by : string;  (** the label of what failed; [judge] if the judge itself *)
  truth : float list;  (** x, y, heading, clearance, touches, driven, odometry error *)
  measured : (string * float) list;  (** by {!Measures.t.probe}, at its end *)
}

type evidence = {
  run : run;  (** it *)
  truth : float list;  (** as in a run, of the one that can be looked at, which is shrunk *)
  around : string list;  (** lines with what the program gave at the last two instants *)
  shrunk : string;  (** what it needs of the world's disturbances to fail so, if not all *)
  picture : string;
  view : string;  (** the command that shows it *)
}
(** What can be looked at of a run that failed. *)

type t = {
  file : string;
  label : string;
  lasts : float;
  measures : Measures.t list;
  chance : Chance.t option;
  note : string;  (** that is told beside it; or empty *)
  result : (run list, string) result;  (** or why it could not be run *)
  evidence : evidence option;
}

type skipped = {
  path : string;  (** of its program *)
  name : string;  (** its label *)
  what : string;  (** that it needs *)
  command : string;  (** that runs it *)
}
(** A test that was not run, as it needs what is given on the command line alone. *)

val failures : t -> run list
val has_failed : t -> bool

val decided : t -> int option
(** After how many of its runs it could be said whether it holds with the chance that is asked for;
    nothing if it cannot be, or if none is. *)

val print : t -> unit
(** A line on standard output, and more below it if it has failed. *)

val print_skipped : skipped -> unit
val print_total : t list -> skipped:int -> unit

val json : t -> string
(** An object in a line. *)

val skipped_json : skipped -> string

val junit : t list -> skipped list -> string
(** A document as CI servers read it. *)
