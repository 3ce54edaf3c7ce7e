(** Translates the parser's facts into diagnostics. *)

open Basis

type t
(** The diagnostics reported so far for the current file, so that a hint about the whole file
    appears only once. *)

val create : unit -> t
val diagnostics : t -> Syntax.Fact.t -> Diagnostic.t list

val into : Diagnostic.sink -> Syntax.Fact.t Facts.t
(** Translates each fact into a diagnostic and emits it to the sink. *)
