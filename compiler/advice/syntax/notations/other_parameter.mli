(** Calls that read a parameter, as in ROS: [get_param("speed", 0.3)]. *)

val type_of : string -> string
(** The type of a value, guessed from its source text. *)

val declaration : name:string -> string -> string
(** [param speed :: Float[m/s] = 0.3[m/s]] for this name and default. *)

val of_arguments : string -> int -> (string * string) option
(** The name and the declaration for [("speed", 0.3[m/s])] or [ "speed" 0.3[m/s]] at this offset. If
    the default is missing or is not a plain value, the declaration has the default 1. *)

val is_its_definition : string -> int -> string -> bool
(** Does the code at this offset define this name at the top level? *)

val hint : string -> int -> string * string -> string
(** The hint that suggests declaring the parameter in this way, and writing its name instead of the
    call at this offset. *)
