(** The robots that programs can be compiled for, and the one that a program is compiled for.

    Codes: [E0502] the program leaves the robot open, and nobody says which · [E0503] it does not
    fit the robot. *)

open Basis

type t = Cgen.Robot.t

val names : string list

val unfit : string
(** The code of a program that does not fit the robot, or any. *)

val known : string option -> (t option, string) result
(** The robot asked for, if any: one of the library by its name, or a user's own by the file of its
    module, which ends in [.frob]. The error is a text for the user. *)

val own_of : string option -> t option
(** The robot asked for, if it is a user's own and there. *)

type program = {
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  entry : Core.Ir.Global.t;
  signed : bool;  (** the programmer says the entry's type *)
  own : t option;  (** the user's own robot, if the program is for one *)
}
(** A program for a robot, before it is decided for which. *)

val input : t -> Core.Ir.Global.t
(** The type of what it senses. *)

val check_own : Diagnostic.sink -> Typing.Ir.program -> t -> unit
(** Emits a diagnostic if the module of a user's own robot lacks the records of its input and
    output, or the instance of [RobotOutput]. *)

val is_open : program -> bool
(** Its type leaves the robot open. *)

val closed : Diagnostic.sink -> t option -> program -> (Core.Ir.program * Core.Ir.Global.t) option
(** The program for a robot, and its entry: closed, if its type leaves the robot open, by the robot
    asked for, or, without a signature, by that of [RobotInput]. Emits diagnostics if it cannot be;
    [None] after them. *)

val sampled : program -> (Core.Ir.program * Core.Ir.Global.t) option
(** An open program, closed by the first robot that fits, for checks that need any; [None] if none
    does. *)
