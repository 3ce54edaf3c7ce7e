(** The command that converts recordings: its arguments and help text. *)

open Cmdliner

val convert : int Cmd.t
