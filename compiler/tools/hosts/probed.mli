(** The inner signals that a run shows. *)

val asks_for_list : Common_options.t -> bool
(** Whether the user wants the names of all inner signals rather than a run. *)

val print_list : Common_options.t -> entry:string -> string -> int
(** Prints the names of all inner signals. *)

val with_claims : Common_options.t -> Common_options.t
(** Adds the verdicts of assertions to the recorded signals. *)
