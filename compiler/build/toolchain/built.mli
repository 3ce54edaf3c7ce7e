(** Compiles programs to C, and builds the generated C with the runtime and the user's own files. *)

type linked = {
  machine : Toolchain.machine option;  (** [None]: this machine *)
  inputs : string list;
  includes : string list;
  generated : (string * string) list;  (** additional files, with names and contents *)
  sees : bool;  (** whether its host supports cameras *)
  ros2 : bool;  (** whether its host is a ROS 2 node *)
}
(** The files that generated C is linked with, and the target machine; see {!Toolchain.build}. *)

val host_table : entry:string -> Cgen.Emit.t -> (string, string) result
(** The table with which hosts read and write the program's values. *)

val for_robot : name:string -> sees:bool -> ?ros2:bool -> Cgen.Emit.t -> (unit, string) result
(** Checks that an executable can be built from the program [name]. The program must be for a robot,
    or be a ROS 2 node if the host is one. If the host does not support cameras, the program must
    not use them. If the host is not a ROS 2 node, the program must not be for the robot [ros], and
    must not use a sensor that only the simulator has. *)

val built :
  ?quiet:bool ->
  ?batch:bool ->
  Common_options.t ->
  Toolchain.kind ->
  entry:string ->
  sources:string list ->
  linked:(Resources.t -> name:string -> linked) ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Compiles a file to C, and builds the generated C together with the user's own [sources]. Passes
    the path of the result to the continuation, or reports the errors. [name] is the base name of
    the C files. *)

val shared :
  ?quiet:bool ->
  ?batch:bool ->
  ?generated:(string * string) list ->
  ?options:string list ->
  Common_options.t ->
  entry:string ->
  sources:string list ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Builds a shared object for a host. [quiet] suppresses warnings; [generated]: additional C files;
    [options]: options of the C compiler. *)

val hosted :
  ?goes_on:bool ->
  Common_options.t ->
  entry:string ->
  sources:string list ->
  string ->
  host:(Resources.t -> string) ->
  arguments:(Resources.t -> string -> string list) ->
  int
(** Replaces this process with a host, which loads the program as a shared object. So the host
    receives the signals sent to frobc. [arguments] computes the host's arguments from the path of
    that object. If [goes_on] is true, the host is a child process instead, and the result is its
    exit status. *)

val missing_host : string -> int
(** Reports that the host is missing, and returns the exit status. *)
