(** The commands that judge programs, in many runs: their options and texts. *)

open Cmdliner

val test : int Cmd.t
val sweep : int Cmd.t
