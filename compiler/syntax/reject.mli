(** How the grammar's actions give up: a piece that reads well but means nothing. {!Parse} reports
    the diagnostic and goes on with the next top-level item. *)

open Basis

exception Rejected of Diagnostic.t

val diagnostic : Diagnostic.t -> 'a
(** Raises {!Rejected}. *)

val at : code:string -> Span.t -> ?hint:string -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Rejected} with a plain error. *)
