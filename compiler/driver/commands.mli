(** What the commands of [frobc] do. Each gives the exit status; results go to
    standard output, everything else to standard error. *)

val with_claims : General.t -> General.t
(** With the verdicts on assertions among what is recorded. *)

val check : General.t -> string list -> int
val compile :
  General.t -> string -> batch:bool -> standalone:bool -> string -> string -> int

type engine =
  | C  (** the compiled program *)
  | Interpreter

val trace :
  General.t ->
  engine ->
  entry:string ->
  sources:string list ->
  modes:bool ->
  input:string option ->
  output:string option ->
  picture:string option ->
  string ->
  int

(** How a run is shown while it goes on. *)
type look = {
  browser : bool;  (** is opened, if there is a desktop *)
  control : bool;  (** pages may do more to a real robot than stop it *)
}

type run = {
  world : string option;
  duration : float option;
      (** s; a minute if [None], and without end if the run is shown *)
  rate : float;  (** Hz *)
  seed : int;
  realtime : bool;
  record : string option;
  picture : string option;
  strict : bool;
  exit_when_done : bool;  (** end when the program has ended *)
  console : bool;  (** keys typed on standard input are the program's *)
  look : look option;
}

(** [sources]: the user's C files for a program that calls them. *)

val run : General.t -> entry:string -> sources:string list -> run -> string -> int

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
(** Goes on with the command that shows the run of a program while it goes on, of which the ring
    is still to be named; nothing if that is not wanted. [world]: where it drives, if that is
    known. *)

type view = {
  recording : string option;  (** [None]: of a run that is not over, only to be built for *)
  browser : bool;  (** is opened, if there is a desktop *)
  port : int option;  (** any that is free if [None] *)
  world : string option;  (** where the robot drove; as for a {!run} if [None] *)
  seed : int;  (** of the simulator, if it is to drive again *)
  only_build : bool;  (** print the path of what is to be run, and show nothing *)
}

val view : General.t -> entry:string -> sources:string list -> view -> string -> int
(** Shows a recorded run on a page, until it is ended. *)

val report : General.t -> entry:string -> states:bool -> string -> int
(** Prints what the program needs, in the format of the diagnostics; or its state diagram,
    for Graphviz. *)

val header : string -> int
(** Prints the C header with a robot's types. *)

val robot_header : Resources.t -> Robots.t -> (string * string, string) result
(** Its name and text, or a text for the user. *)

val explain : string -> int

val compiled :
  ?quiet:bool ->
  ?batch:bool ->
  General.t ->
  Resources.t ->
  entry:string ->
  string ->
  (Cgen.Emit.t -> int) ->
  int
(** Compiles a file to C and goes on with it; tells what is wrong with it
    otherwise. [quiet]: only errors are told, no warnings. *)

val host_table : entry:string -> Cgen.Emit.t -> (string, string) result
(** The table by which hosts read and write the program's values. *)

val as_output : Output.content -> string -> string -> Output.t
(** [as_output content option path] *)

val all_exist : string list -> (unit, string) result
(** Whether the files named on the command line are there. *)

(** What generated C is linked with, and for what; see {!Toolchain.build}. *)
type linked = {
  machine : Toolchain.machine option;  (** this one if [None] *)
  inputs : string list;
  includes : string list;
  generated : (string * string) list;  (** more files, name and content *)
  sees : bool;  (** it has hosts for programs with cameras *)
}

val for_robot : name:string -> sees:bool -> Cgen.Emit.t -> (unit, string) result
(** Executables and boards drive a robot, and boards have no camera; an error of a program [name]
    for no robot, or with a camera where the host has none. *)

val built :
  ?quiet:bool ->
  ?batch:bool ->
  General.t ->
  Toolchain.kind ->
  entry:string ->
  sources:string list ->
  linked:(Resources.t -> name:string -> linked) ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Compiles a file, to C and by the C compiler with the user's own [sources],
    and goes on with the path of the result; tells what is wrong with it
    otherwise. [name] is that of the C files. *)

val shared :
  ?quiet:bool ->
  ?batch:bool ->
  ?generated:(string * string) list ->
  ?options:string list ->
  General.t ->
  entry:string ->
  sources:string list ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Likewise, of a shared object for a host. [quiet]: only errors are told, no warnings;
    [generated]: more C files; [options]: for the C compiler. *)

val accepted :
  ?quiet:bool ->
  (Basis.Diagnostic.sink -> Basis.Source.t -> Request.t -> 'result option) ->
  General.t ->
  ?batch:bool ->
  Resources.t ->
  entry:string ->
  string ->
  (Request.t -> 'result -> int) ->
  int
(** Goes on with what a pipeline gives, or gives the status with which to end. *)

val for_world : General.t -> Resources.t -> string -> (General.t, string) result
(** With the robot that the world names, if none is asked for. *)
