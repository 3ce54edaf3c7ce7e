(** Names that users know from Haskell, Yampa, C, Python, MATLAB and board libraries, and that have
    a different name or no counterpart in Frob.

    Words that a robot program is likely to use for its own definitions, such as [range] and
    [error], are left out: an unknown [range] is more likely a misspelt name of the program. *)

val of_each : string -> (string * string) list option
(** The functions in place of one for several types of containers, each with its container. *)

val applied : string -> string list -> (string * string option) option
(** The application of such a name to these arguments in Frob, and the module of the library that it
    needs. *)

val is_an_object : string -> bool
(** Does the name mean the object of a method, such as [self]? *)

val is_of_gains : string -> bool
(** Is it the name of a controller with three gains? *)

val value : string -> string option
(** A hint for an unknown value name, used if no similar Frob name is in scope. *)

val robot : string -> string option
(** A hint for the name of a robot sensor or action, used if the program does not contain a similar
    name. *)

val reading : string -> (string -> string, unit, string) format option
(** The sensor reading that a name from elsewhere means, as a format for the name of the robot's
    input. *)

val current : string -> string list
(** The names to whose previous value this name may refer: [v] for [v_prev] and [prevV]. *)

val is_of_speed : string -> bool
(** Does this word, for which {!robot} has a hint, set the speed and the turn rate of a robot? *)

val is_statement : string -> bool
(** Is this the keyword of a statement in another language? If so, the code after it is in that
    language too. *)

val constructor : string -> string option
(** A hint for an unknown constructor, in an expression or a pattern. *)

val type_ : string -> string option
(** A hint for an unknown type. *)

val class_ : string -> string option
(** A hint for an unknown type class. *)

val qualifier : string -> string option
(** A hint for a module of another language that qualifies a name, as in [Math.sqrt]. *)

val module_ : string -> string option
(** A hint for an unknown module, as in [import Math]. *)

val in_library : string -> (string * string) option
(** The contents of an unknown module, as a subject and its verb ([the sonars are]), and the library
    module that contains them. *)
