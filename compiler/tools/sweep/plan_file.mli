(** Reads the plan file of a sweep. *)

val read : Resources.t -> string -> (Plan.t, string) result
(** Reads a plan file with the help of the simulator. The error contains one line for each mistake,
    in the format of other messages. *)
