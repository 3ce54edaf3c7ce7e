(** The command that converts recordings: its arguments and texts. *)

open Cmdliner

val convert : int Cmd.t
