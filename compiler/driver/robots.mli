(** The robots that programs can be compiled for, and the one that a program is
    compiled for.

    Codes: [E0502] the program leaves the robot open, and nobody says which ·
    [E0503] it does not fit the robot. *)

open Basis

type t = Cgen.Robot.t

val names : string list

val known : string option -> (t option, string) result
(** The robot asked for, if any; the error is a text for the user. *)

(** A program for a robot, before it is decided for which. *)
type program = {
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  entry : Core.Ir.Global.t;
  signed : bool;  (** the programmer says the entry's type *)
}

val is_open : program -> bool
(** Its type leaves the robot open. *)

val closed : Diagnostic.sink -> t option -> program -> (Core.Ir.program * Core.Ir.Global.t) option
(** The program for a robot, and its entry: closed, if its type leaves the
    robot open, by the robot asked for, or, without a signature, by that of
    [RobotInput]. Emits diagnostics if it cannot be; [None] after them. *)

val sampled : program -> (Core.Ir.program * Core.Ir.Global.t) option
(** An open program, closed by the first robot that fits, for checks that need
    any; [None] if none does. *)
