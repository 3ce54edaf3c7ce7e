(** The paths of the standard library, the runtime and the hosts. *)

type t = {
  prefix : string;  (** folder of the installation, which contains [lib] and [share] *)
  library : string;  (** folder of the standard library's [.frob] files *)
  headers : string;
      (** folder for the C compiler's option [-I]; contains [frob/program.h] and other headers *)
  runtime : string;  (** archive [libfrob.a], which generated C is linked with *)
  robot_host : string;
      (** archive [libfrob-robot.a]: the host that drives a robot, without a program *)
  runtime_sources : string;  (** sources of the robot hosts, with their drivers and ports *)
  elementary : string;  (** folder with the sources of [runtime] *)
  own_compiler : string;  (** executable [frob-tcc], for computers without a C compiler *)
  trace_host : string;  (** executable [frob-trace] *)
  viewer : string;  (** executable [frob-view] *)
  simulator : string;  (** executable [frob-sim] *)
  server : string;  (** executable [frob-serve], which simulates robots on a serial line *)
  worlds : string;  (** folder of the worlds that come with the simulator *)
  selftest : string;  (** folder of the programs and C files of {!Selftest} *)
  template : string;  (** folder of the templates of {!New_project} *)
  demo : string;  (** folder of the example that {!Demo} copies *)
  python : string;  (** folder of the Python package [frob], for [PYTHONPATH] *)
}
