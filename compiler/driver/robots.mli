(** The robots that programs can be compiled for. *)

val names : string list

val known : string option -> (unit, string) result
(** Whether the robot asked for, if any, is one of them; the error is a text
    for the user. *)
