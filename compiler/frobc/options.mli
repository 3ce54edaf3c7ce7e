(** What several commands take on the command line. *)

open Cmdliner
module General := Driver.General

val exits : Cmd.Exit.info list

val command : string -> doc:string -> ?man:Manpage.block list -> int Term.t -> int Cmd.t
(** With the statuses with which all commands exit. *)

(** {1 Arguments} *)

val file : string Term.t
val files : string list Term.t

val entry : string Term.t
(** [--entry] *)

val sources : string list Term.t
(** [--with]: the user's own C *)

val real : Basis.Real.t Term.t

val robot_names : string
(** Of the library, for a manual page. *)

val time_span : float Arg.conv
(** [1.5s], [2min]: in seconds. *)

(** {1 General options} *)

val general : General.t Term.t

val probed : General.t Term.t
(** With [--probe]. *)

val judging : General.t Term.t -> General.t Term.t
(** With [--asserts]: of a command that runs a program. *)

val not_judging : General.t Term.t -> General.t Term.t
(** With [--asserts]: of one that only compiles it. *)

val with_params : General.t Term.t -> General.t Term.t
(** With [--param]. *)
