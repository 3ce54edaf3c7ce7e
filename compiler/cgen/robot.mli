(** The robots whose input and output types are declared in a module of the
    standard library, and as C structs in a header that is installed with
    [frobc]. *)

type t = {
  module_ : string;  (** [Pioneer]: it declares [PioneerInput], [PioneerOutput] *)
  name : string;  (** [pioneer], for hosts and users *)
  header : string;  (** [frob/pioneer.h] *)
}

val all : t list
(** In the order in which users are told of them. *)

val default : t
(** The robot of the library's [RobotInput] and [RobotOutput]. *)

val of_name : string -> t option

(** {1 Types}

    Of the robot's module. *)

val input : t -> string
(** Of what it senses. *)

val output : t -> string
(** Of what it can do. *)

val of_shape : Flow.Ir.shape -> t option
(** The robot that a program's whole input or output belongs to. *)
