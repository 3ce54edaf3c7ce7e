(** [frobc falsify]: see {!Tools.Falsification}. *)

val falsify : int Cmdliner.Cmd.t
