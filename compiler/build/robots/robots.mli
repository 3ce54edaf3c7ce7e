(** The robots that programs can be compiled for, and the choice among them.

    Reports [E0502] if neither the program nor an option determines the robot, and [E0503] if the
    program does not fit the robot. *)

open Basis

type t = Cgen.Robot.t

val names : string list

val unfit : string
(** The error code for a program that does not fit the chosen robot, or does not fit any robot. *)

val known : string option -> (t option, string) result
(** The robot that the option names, if the option is given: a robot in the library by its name, or
    a user-defined robot by the file of its module, which ends in [.frob]. The error is a message
    for the user. *)

val own_of : string option -> t option
(** The robot that the option names, if it is user-defined and exists. *)

type program = {
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  entry : Core.Ir.Global.t;
  signed : bool;  (** whether the entry has a type signature *)
  own : t option;  (** the user-defined robot, if the program is for one *)
}
(** A program for a robot that has not been chosen yet. *)

val input : t -> Core.Ir.Global.t
(** The type of a robot's sensor values. *)

val check_own : Diagnostic.sink -> Typing.Ir.program -> t -> unit
(** Reports an error if the module of a user-defined robot lacks the records of its input and
    output, or the instance of [RobotOutput]. *)

val is_open : program -> bool
(** Whether the program's type leaves the robot open. *)

val closed : Diagnostic.sink -> t option -> program -> (Core.Ir.program * Core.Ir.Global.t) option
(** The program for a specific robot, with its entry. If the program's type leaves the robot open,
    uses the robot that the option names or, for an entry without a signature, the robot of
    [RobotInput]. Returns [None] after an error. *)

val sampled : program -> (Core.Ir.program * Core.Ir.Global.t) option
(** Like {!closed}, but chooses the first robot that fits an open program, for checks that need a
    robot; [None] if none fits. *)
