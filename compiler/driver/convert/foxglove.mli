(** Messages as Foxglove and PlotJuggler know them, in JSON: the schemas of that name, as far as
    they are used here. Lengths in m, angles in rad, times in ns. *)

type schema = string * string
(** Its name and its JSON Schema. *)

val number : string -> string
(** A number's text as JSON has it, of what is finite. *)

val words : string -> string
(** In quotes. *)

(** {1 Places} *)

type pose = { x : float; y : float; heading : float }

val pose_in_frame : schema
val of_pose : time:int -> frame:string -> pose -> string
val frame_transform : schema

val of_transform : time:int -> parent:string -> child:string -> pose -> string
(** Where the child's frame is in the parent's. *)

(** {1 Ranges} *)

val scene_update : schema

type echo = { id : string; seat : pose; half_angle : float; range : float; lasts : int }
(** [lasts]: for how long it is shown, if there is no other of this [id]. *)

val of_echoes : time:int -> frame:string -> echo list -> string
(** Each is a cone: where it may have come from. *)

(** {1 Images} *)

val raw_image : schema
(** With two members that Foxglove has not: the name of the frame's file, and its head. *)

type image = { file : string; head : string; width : int; height : int; pixels : string }

val image : file:string -> string -> image option
(** Of a binary PPM or PGM; [None] of anything else. *)

val of_image : time:int -> frame:string -> image -> string

val file_of : string -> (string * string) option
(** Of a message that {!of_image} has made: the frame's file, its name and what is in it. *)
