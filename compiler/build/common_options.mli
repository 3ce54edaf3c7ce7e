(** Options shared by all commands that compile programs. *)

type format = Text | Json

(** The treatment of a program's assertions. *)
type asserts =
  | Off  (** they are not compiled *)
  | Count  (** hosts judge them and report the results *)
  | Stop  (** like [Count], but the first violated assertion ends the run *)
  | Margin  (** hosts judge them and report how far each was from being violated *)

type t = {
  format : format;  (** format of diagnostics and reports *)
  dump : Stage.t option;  (** print the program after this stage *)
  stop_after : Stage.t option;
  lint : bool;  (** check each stage's invariants *)
  specialization_limit : int;
  real : Basis.Real.t;  (** the precision of [Float] *)
  robot : string option;  (** the robot, for a program that works with several robots *)
  probes : string list;  (** names of inner signals to show; see {!Probe.Selection} *)
  asserts : asserts;
  params : string list;  (** values of the program's parameters, each [NAME=VALUE] *)
}

val default : t
(** The default options: text messages, double precision and no assertions. *)

val to_repeat : t -> sources:string list -> string list
(** The options with which a command compiles the same program for the same robot, quoted for a
    shell. Omits options with default values, and the parameters, which a command sets when it runs
    a program. [sources] are the files given with [--with]. *)

val assert_options : t -> string list
(** The options that tell a host how to treat assertions. *)
