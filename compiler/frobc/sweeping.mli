(** The command that performs many runs of a trial, with different worlds, robots, parameters and
    seeds: its options and help texts. *)

open Cmdliner

val sweep : int Cmd.t
