(** The command that runs tests and trials: its options and help texts. *)

open Cmdliner

val test : int Cmd.t
