(** Arguments and options that several commands share. *)

open Cmdliner
module Common_options := Build.Common_options

val exits : Cmd.Exit.info list

val command : string -> doc:string -> ?man:Manpage.block list -> int Term.t -> int Cmd.t
(** Adds the exit statuses that all commands share. *)

(** {1 Arguments} *)

val file : string Term.t
val files : string list Term.t

val entry : string Term.t
(** The option [--entry]. *)

val sources : string list Term.t
(** The option [--with]: the user's own C files. *)

val real : Basis.Real.t Term.t

val robot_names : string
(** The robots in the library, for a manual page. *)

val some_string : string -> docv:string -> doc:string -> string option Term.t
(** An option with this name whose value is a string. *)

val jobs : int option Term.t
(** The option [--jobs]. *)

val positive : string -> int option -> (unit, string) result
(** Checks that the value of the option with this name is at least 1, if it is given. *)

val time_span : float Arg.conv
(** A time such as [1.5s] or [2min], converted to seconds. *)

(** {1 General options} *)

val general : Common_options.t Term.t

val probed : Common_options.t Term.t
(** The general options, and [--probe]. *)

val judging : Common_options.t Term.t -> Common_options.t Term.t
(** Adds [--asserts], for a command that runs a program. *)

val not_judging : Common_options.t Term.t -> Common_options.t Term.t
(** Adds [--asserts], for a command that only compiles a program. *)

val with_params : Common_options.t Term.t -> Common_options.t Term.t
(** Adds [--param]. *)

val dialect : Interp.Dialect.t Term.t
(** The options [--separator], [--decimal-comma], [--time-column] and [--column], for commands that
    read a recording. *)
