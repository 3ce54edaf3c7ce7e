(** Turns the facts of the parser into diagnostics. *)

open Basis

type t
(** The diagnostics so far of the file that is being parsed, so that a hint about the whole file is
    given only once. *)

val create : unit -> t
val diagnostics : t -> Syntax.Fact.t -> Diagnostic.t list

val into : Diagnostic.sink -> Syntax.Fact.t Facts.t
(** Translates each fact to a diagnostic and emits it to the sink. *)
