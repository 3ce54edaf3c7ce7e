(** [frobc view], and what is shown of a run that goes on. *)

type look = {
  browser : bool;  (** is opened, if there is a desktop *)
  control : bool;  (** pages may do more to a real robot than stop it *)
}
(** How a run is shown while it goes on. *)

val shown :
  ?params:Params.set list ->
  General.t ->
  entry:string ->
  sources:string list ->
  look option ->
  record:string option ->
  world:string option ->
  string ->
  (string list -> int) ->
  int
(** Goes on with the command that shows the run of a program while it goes on, of which the ring is
    still to be named; nothing if that is not wanted. [world]: where it drives, if that is known. *)

type view = {
  recording : string option;  (** [None]: of a run that is not over, only to be built for *)
  browser : bool;  (** is opened, if there is a desktop *)
  port : int option;  (** any that is free if [None] *)
  world : string option;  (** where the robot drove; as for a {!run} if [None] *)
  seed : int;  (** of the simulator, if it is to drive again *)
  at : float option;  (** the time to show first, in seconds *)
  only_build : bool;  (** print the path of what is to be run, and show nothing *)
}

val view : General.t -> entry:string -> sources:string list -> view -> string -> int
(** Shows a recorded run on a page, until it is ended. *)
