(** [frobc view], and the live view of a run. *)

type look = {
  browser : bool;  (** whether to open a browser, if there is a desktop *)
  control : bool;  (** whether pages may control a real robot, rather than only stop it *)
}
(** How a run is shown live. *)

val shown :
  ?params:Params.set list ->
  Common_options.t ->
  entry:string ->
  sources:string list ->
  look option ->
  record:string option ->
  world:string option ->
  string ->
  (string list -> int) ->
  int
(** Calls the function with the command that shows the run live. The caller must append the name of
    the ring buffer. The command is empty if [look] is [None]. [world] is the world the robot drives
    in, if it is known. *)

type view = {
  recording : string option;
      (** [None] for a run that is still in progress; allowed only with [only_build] *)
  dialect : Interp.Dialect.t;  (** dialect of the recording *)
  browser : bool;  (** whether to open a browser, if there is a desktop *)
  port : int option;  (** [None]: any free port *)
  world : string option;
      (** the world of the recorded run; [None]: the default of {!Where.world_of} *)
  compare : string option;  (** a second recording to show on top of the first one *)
  seed : int;  (** seed with which to repeat the run in the simulator *)
  at : float option;  (** the time to show first, in seconds *)
  only_build : bool;  (** whether to print only the path of the executable *)
  why_nan : bool;  (** whether to print only the origin of NaN in the output *)
}

val view : Common_options.t -> entry:string -> sources:string list -> view -> string -> int
(** Shows a recorded run on a page, until the user ends the command. *)
