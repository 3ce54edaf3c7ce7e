(** Prepares a sweep and reports errors before its first run. *)

val of_plan : Common_options.t -> sources:string list -> string -> (Setup.t, int) result
(** Reads a plan file. Errors are reported with their place in the plan; the result is then the exit
    status. Each place is tried for one instant, so that the sweep does not start if a run is
    impossible. *)
