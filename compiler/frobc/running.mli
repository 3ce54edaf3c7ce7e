(** The commands that run programs: their options and help texts. *)

open Cmdliner

val trace : int Cmd.t
val run : int Cmd.t
val demo : int Cmd.t
