(** The options and help texts of the command that shows runs on a page, and of other commands that
    can do so. *)

open Cmdliner

val look : (Tools.Viewing.look option, string) result Term.t
(** The options [--view] and [--print] of a command that runs a program. The value says how to show
    the run. The error explains why the options are invalid. *)

val view : int Cmd.t
