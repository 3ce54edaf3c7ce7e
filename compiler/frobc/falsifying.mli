(** [frobc falsify]: see {!Driver.Falsification}. *)

val falsify : int Cmdliner.Cmd.t
