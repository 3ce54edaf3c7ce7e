(** What the commands of [frobc] do. Each gives the exit status; results go to
    standard output, everything else to standard error. *)

type format = Text | Json

(** What is done with the assertions of a program. *)
type asserts =
  | Off  (** nothing of them is compiled *)
  | Count  (** they are judged, and what became of them is told *)
  | Stop  (** and the first that is violated ends the run *)

type general = {
  format : format;  (** of diagnostics, and of a report *)
  dump : Stage.t option;
  stop_after : Stage.t option;
  lint : bool;
  specialization_limit : int;
  real : Basis.Real.t;  (** the precision of [Float] *)
  robot : string option;  (** the robot to compile for, where the program leaves it open *)
  probes : string list;  (** inner signals to be seen, as {!Probe.Selection} takes them *)
  asserts : asserts;
  params : string list;  (** values of the program's parameters, [NAME=VALUE] each *)
}

val with_params :
  general -> Resources.t -> entry:string -> string -> (Params.set list -> int) -> int
(** Goes on with what the program's parameters are set to; a wrong setting is told. *)

val param_options : Params.set list -> string list
(** For a host. *)

val with_claims : general -> general
(** With the verdicts on assertions among what is recorded. *)

val assert_options : general -> string list
(** For a host. *)

val request :
  general ->
  ?robot:Robots.t ->
  ?entry:string ->
  ?batch:bool ->
  library:string ->
  string ->
  Request.t
(** What these options ask of the compiler for a file. *)

val status : Basis.Diagnostic.sink -> int
(** The exit status of a command that went as far as it could. *)

val check : general -> string list -> int
val compile :
  general -> string -> batch:bool -> standalone:bool -> string -> string -> int

type engine =
  | C  (** the compiled program *)
  | Interpreter

val trace :
  general ->
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

val run : general -> entry:string -> sources:string list -> run -> string -> int

val shown :
  ?params:Params.set list ->
  general ->
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

val view : general -> entry:string -> sources:string list -> view -> string -> int
(** Shows a recorded run on a page, until it is ended. *)

val report : general -> entry:string -> states:bool -> string -> int
(** Prints what the program needs, in the format of the diagnostics; or its state diagram,
    for Graphviz. *)

val header : string -> int
(** Prints the C header with a robot's types. *)

val robot_header : Resources.t -> Robots.t -> (string * string, string) result
(** Its name and text, or a text for the user. *)

val explain : string -> int

val wrong_use : string -> int
(** Says what is wrong with the call, and not with the program. *)

val compiled :
  ?quiet:bool ->
  ?batch:bool ->
  general ->
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
}

val for_robot : name:string -> Cgen.Emit.t -> (unit, string) result
(** Executables and boards drive a robot, and have no camera yet; an error of a program [name]
    for no robot, or with a camera. *)

val built :
  ?quiet:bool ->
  general ->
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
  ?generated:(string * string) list ->
  ?options:string list ->
  general ->
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
  general ->
  ?batch:bool ->
  Resources.t ->
  entry:string ->
  string ->
  (Request.t -> 'result -> int) ->
  int
(** Goes on with what a pipeline gives, or gives the status with which to end. *)

val world_of : string option -> Resources.t -> string -> string
(** The world that is asked for, or that lies beside a program, or that comes with frobc. *)

val for_world : general -> Resources.t -> string -> (general, string) result
(** With the robot that the world names, if none is asked for. *)

val print_diagnostics : format -> Basis.Source.t -> Basis.Diagnostic.sink -> unit

val report_bug : string -> string -> int
(** [report_bug stage message] says that it is a fault of the compiler's own. *)

val report_exception : exn -> int
(** Says what ended the command: what the system refused, which is {!Exit_status.wrong_use},
    or a fault of the compiler's own, {!Exit_status.bug}. *)
