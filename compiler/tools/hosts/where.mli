(** Finds the world in which a robot is simulated, and the robot that the world names. *)

type from = Here | Beside of string  (** the current folder, or the folder of the given file *)

val find : Resources.t -> from list -> string -> (string, string) result
(** The path of the world with this name. If the name is not an absolute path, searches these places
    in order, and then the worlds that come with frobc. The error distinguishes a missing world from
    an unreadable one. *)

val beside : string -> string -> string
(** [beside file name] resolves the path [name] relative to the folder of [file]. *)

val world_of : string option -> Resources.t -> string -> (string, string) result
(** [world_of given resources file]: the world that the user named, looked up first in the current
    folder and then in the program's folder. If the user did not name a world, [world.toml] in the
    program's folder; if that does not exist, the room that comes with frobc. *)

val for_world : Common_options.t -> Resources.t -> string -> (Common_options.t, string) result
(** Uses the robot that the world names, unless the user chose a robot. *)
