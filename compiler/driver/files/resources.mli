(** Where the standard library, the runtime and the hosts lie: beside [frobc], in an installation or
    in the build, or in [FROB_HOME]. *)

type t = {
  prefix : string;  (** the folder of the installation, with [lib] and [share] *)
  library : string;  (** folder of the [.frob] standard library *)
  headers : string;  (** to be passed as [-I]: holds [frob/program.h] … *)
  runtime : string;  (** the archive [libfrob.a] that generated C is linked with *)
  robot_host : string;
      (** the archive [libfrob-robot.a]: the host that drives a robot, without a program *)
  runtime_sources : string;  (** of the robot hosts, with their drivers and ports *)
  elementary : string;  (** folder of the sources of [runtime] *)
  trace_host : string;  (** the executable [frob-trace] *)
  viewer : string;  (** the executable [frob-view] *)
  simulator : string;  (** the executable [frob-sim] *)
  server : string;  (** the executable [frob-serve], of simulated robots on a line *)
  worlds : string;  (** folder of the worlds that come with the simulator *)
  selftest : string;  (** folder of the programs and the C of {!Selftest} *)
  template : string;  (** folder of the files of {!New_project} *)
}

val find : unit -> (t, string) result
(** The error says where it was looked for, and the cure. *)
