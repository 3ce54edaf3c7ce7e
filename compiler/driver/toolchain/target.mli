(** The machines that executables for robots are made for. *)

type t

val names : string list
val of_name : string -> t option

val meaning : t -> string
(** In a few words, for the user. *)

val own_driver : name:string -> Cgen.Robot.t option -> string * string
(** The file, name and content, that tells the host which driver is the user's own: of the robot
    [rover] it is [const struct frob_driver frob_rover_driver]. *)

val linked :
  ?own:Cgen.Robot.t -> t -> real:Basis.Real.t -> Resources.t -> name:string -> Built.linked
(** [own]: the user's own robot, whose driver is among the user's C files. *)

val size_tool : t -> string option
(** The program that tells how much memory an executable needs, where that is of interest. *)

val state_of : string -> string * string
(** The file, name and content, with the memory of a program's state, for hosts without a heap. *)
