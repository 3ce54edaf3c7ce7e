(** The command that runs a trial with many parameters: its options and help texts. *)

open Cmdliner

val sweep : int Cmd.t
