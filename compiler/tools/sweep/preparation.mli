(** Prepares a sweep and reports errors before its first run. *)

val of_plan : Common_options.t -> sources:string list -> string -> (Setup.t, int) result
(** Reads a plan file. If there are errors, reports them with their position in the plan and returns
    the exit status. Runs each place for one instant, so that a sweep with an impossible run does
    not start. *)
