(** The robots: for each a module that declares its input and output types, which are C structs in a
    header of its own. Those of the standard library come with [frobc]; another is a user's own
    module. *)

type t = {
  module_ : string;  (** [Pioneer]: it declares [PioneerInput], [PioneerOutput] *)
  name : string;  (** [pioneer], for hosts and users *)
  header : string;  (** [frob/pioneer.h], or [rover.h], which is written beside the program *)
  file : string option;  (** of the module, if it is the user's own *)
}

val all : t list
(** Those of the library, in the order in which users are told of them. *)

val default : t
(** The robot of the library's [RobotInput] and [RobotOutput]. *)

val of_name : string -> t option
(** Of the library. *)

val own : string -> t
(** The robot whose module is in this file: [Rover.frob] is of the robot [rover]. *)

val is_own : t -> bool

val included : t -> string
(** Its header as it stands after [#include]. *)

(** {1 Types}

    Of the robot's module. *)

val input : t -> string
(** Of what it senses. *)

val output : t -> string
(** Of what it can do. *)

val of_shape : ?own:t -> Flow.Ir.shape -> t option
(** The robot that a program's whole input or output belongs to. *)

type console = {
  part : string * Flow.Ir.shape;
  at : int;  (** so many leaves of the robot's are before it *)
}
(** The operator's console in a robot's input is the program's, not the robot's: hosts have it
    behind the robot's struct. *)

val apart : Flow.Ir.shape -> Flow.Ir.shape * console option
(** A robot's input as the robot has it. *)
