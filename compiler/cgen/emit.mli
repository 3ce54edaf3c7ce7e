(** The C files of a program, as text. *)

type t = {
  header : string;  (** NAME.h *)
  source : string;  (** NAME.c *)
  host_table : string option;
      (** NAME_host.c, for hosts only; none of a program with a foreign type in its input or output,
          which no host knows *)
  robot : string option;  (** the name of the robot that it is a program for *)
  robot_header : (string * string) option;
      (** name and text of the header of a user's own robot, which [header] includes; made from the
          robot's module ({!Interface_header}) and so not here *)
  cameras : string list;  (** the labels of those through which it looks *)
  foreign : foreign;
}

and foreign = {
  calls : string list;  (** what the program calls, as in [foreign] declarations *)
  folders : string list;  (** where the headers are that it includes *)
}
(** What the user's C adds to a build. *)

val program : ?own:Robot.t -> ?batch:bool -> Step.Ir.program -> t
(** [own]: the user's own robot, if the program is for one; [batch]: with the function that takes
    many steps ({!Batch}). *)

val print : Format.formatter -> t -> unit
(** The header, then the source. *)
