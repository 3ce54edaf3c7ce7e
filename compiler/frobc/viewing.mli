(** The options and help texts of the command that shows runs on a page, and of other commands that
    can do so. *)

open Cmdliner

val look : (Tools.Viewing.look option, string) result Term.t
(** The options [--view] and [--print] of a command that runs a program: how to show the run, or
    what is wrong with them. *)

val view : int Cmd.t
