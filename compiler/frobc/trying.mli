(** The commands that test programs in many runs: their options and help texts. *)

open Cmdliner

val test : int Cmd.t
val sweep : int Cmd.t
