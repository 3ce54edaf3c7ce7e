(** What a run is to show of the program's inside. *)

val asks_for_list : General.t -> bool
(** Instead of a run, the names of all that could be seen. *)

val print_list : General.t -> entry:string -> string -> int
(** Prints it. *)

val with_claims : General.t -> General.t
(** With the verdicts on assertions among what is recorded. *)
