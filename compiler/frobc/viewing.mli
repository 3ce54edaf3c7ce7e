(** The options and help texts of the command that shows runs on a page, and of other commands that
    can do so. *)

open Cmdliner

val look : (Tools.Viewing.look option, string) result Term.t
(** The options [--view] and [--print] of a command that runs a program. The value says how to show
    the run; the error says what is wrong with the options. *)

val view : int Cmd.t
