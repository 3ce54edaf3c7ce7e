(** The parameters of a program: what they are by default, and what a command line sets them to. *)

open Basis

val defaults : Diagnostic.sink -> Core.Ir.program -> (Core.Ir.param -> Flow.Ir.atom) option
(** Emits E0391 for a value that is not known before the run, or is no number. *)

type set = {
  param : Core.Ir.Global.t;
  setting : string;  (** for hosts: [kTurn=5] *)
  value : Interp.Value.t;
}

val given : Diagnostic.sink -> Core.Ir.program -> set list option
(** Those that were given values; E0391 likewise. *)
