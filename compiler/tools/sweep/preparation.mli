(** Prepares a sweep and reports errors before its first run. *)

val of_plan : Common_options.t -> sources:string list -> string -> (Setup.t, int) result
(** Reads a plan file. Reports errors with their place in the plan; in that case, the result is the
    exit status. Tries each place for one instant, so that the sweep does not start if a run is
    impossible. *)
