(** The world in which a robot is simulated, and the robot that it names. *)

val world_of : string option -> Resources.t -> string -> string
(** [world_of given resources file]: what the user says, else [world.toml] beside the program, else
    a room of the library's. *)

val for_world : General.t -> Resources.t -> string -> (General.t, string) result
(** With the robot that the world names, if none is asked for. *)
