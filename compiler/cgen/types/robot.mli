(** The robots. Each has a module that declares its input and output types, and a header that
    contains these types as C structs. The standard library contains some robots; users can define
    others in their own modules. *)

type step = { quantity : string; size : float; unit_ : string }
(** The smallest change in a quantity that the robot's protocol can express. *)

type t = {
  module_ : string;  (** for example [Pioneer], which declares [PioneerInput] and [PioneerOutput] *)
  name : string;  (** the name for hosts and users, for example [pioneer] *)
  header : string;
      (** for example [frob/pioneer.h], or [rover.h] for a user's own robot, whose header is
          generated next to the program *)
  file : string option;  (** file of the module, if the robot is the user's own *)
  steps : step list;  (** resolution of the speeds in commands; empty for a user-defined robot *)
}

val all : t list
(** The robots of the library, in the order in which they are listed for users. *)

val default : t
(** The robot that the library's [RobotInput] and [RobotOutput] belong to. *)

val of_name : string -> t option
(** Finds a robot of the library. *)

val own : string -> t
(** The robot whose module is in this file: [Rover.frob] defines the robot [rover]. *)

val is_own : t -> bool

val included : t -> string
(** The operand of [#include] for the robot's header. *)

(** {1 Types}

    The names of types that the robot's module declares. *)

val input : t -> string
(** The type of the sensor values. *)

val output : t -> string
(** The type of the commands. *)

val of_shape : ?own:t -> Flow.Ir.shape -> t option
(** The robot whose entire input or output type is this shape. *)

type console = {
  part : string * Flow.Ir.shape;
  at : int;  (** number of the robot's leaves before the console *)
}
(** The operator's console in a robot's input. It belongs to the program, not to the robot; in the
    struct for hosts, it follows the robot's own struct. *)

val apart : Flow.Ir.shape -> Flow.Ir.shape * console option
(** Splits a robot's input into the robot's own part and the console. *)
