(** The inner signals that are recorded in a run. *)

val asks_for_list : Common_options.t -> bool
(** Whether the user asked for the names of all inner signals instead of a run. *)

val print_list : Common_options.t -> entry:string -> string -> int
(** Prints the names of all inner signals. *)

val with_claims : Common_options.t -> Common_options.t
(** Adds the verdicts of assertions to the recorded signals. *)
