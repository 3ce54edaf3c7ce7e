(** The parameters of a program: their default values, and the values that the command line sets. *)

open Basis

val defaults : Diagnostic.sink -> Core.Ir.program -> (Core.Ir.param -> Flow.Ir.atom) option
(** Reports E0391 for a value that is not known before the run, or that is NaN. *)

type set = {
  param : Core.Ir.Global.t;
  setting : string;  (** the setting for hosts, for example [kTurn=5] *)
  value : Interp.Value.t;
}

val given : Diagnostic.sink -> Core.Ir.program -> set list option
(** The parameters that the command line sets. Reports E0391 for the same reasons as {!defaults}. *)

val host_options : set list -> string list
(** The options with which a host sets these parameters. *)
