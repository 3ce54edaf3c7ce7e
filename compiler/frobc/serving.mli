(** The command that simulates a robot for other programs: its options and help texts. *)

open Cmdliner

val serve : int Cmd.t
