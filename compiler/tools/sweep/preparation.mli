(** Prepares a sweep and reports errors before its first run. *)

val of_plan : Common_options.t -> sources:string list -> string -> (Setup.t, int) result
(** Reads a plan file. If there are errors, reports them with their position in the plan and returns
    the exit status. Simulates one instant for each world and robot, so that the sweep does not
    start if one of them cannot be simulated. *)
