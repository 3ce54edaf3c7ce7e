(** Builds messages in Foxglove's JSON schemas, which PlotJuggler understands as well. Lengths are
    in m, angles in rad, and times in ns. *)

type schema = string * string
(** The name of the schema, and its JSON Schema. *)

val number : string -> string
(** Converts a number, given as text, to JSON. Returns the empty string if the number is not finite.
*)

val words : string -> string
(** Converts text to a JSON string. *)

(** {1 Poses} *)

type pose = { x : float; y : float; heading : float }

val pose_in_frame : schema
val of_pose : time:int -> frame:string -> pose -> string
val frame_transform : schema

val of_transform : time:int -> parent:string -> child:string -> pose -> string
(** The pose of the child frame in the parent frame. *)

(** {1 Ranges} *)

val scene_update : schema

type echo = { id : string; seat : pose; half_angle : float; range : float; lasts : int }
(** [lasts]: how long the echo is displayed, unless one with the same [id] replaces it sooner *)

val of_echoes : time:int -> frame:string -> echo list -> string
(** Shows each echo as a cone that contains all places where it may have originated. *)

(** {1 Images} *)

val raw_image : schema
(** In addition to Foxglove's members, the message has two members of our own: the name and the
    header of the frame's file. *)

type image = { file : string; head : string; width : int; height : int; pixels : string }

val image : file:string -> string -> image option
(** Parses a binary PPM or PGM; [None] for anything else. *)

val of_image : time:int -> frame:string -> image -> string

val file_of : string -> (string * string) option
(** The name and contents of the frame's file, restored from a message that {!of_image} created. *)
