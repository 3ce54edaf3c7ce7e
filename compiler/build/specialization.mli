(** From Core to Flow: specializes the entry of a program, and checks the result. *)

open Basis

val program :
  Request.t ->
  Diagnostic.sink ->
  Source.t ->
  options:Specialize.Context.options ->
  default:(Core.Ir.param -> Flow.Ir.atom) ->
  name:string ->
  entry:Core.Ir.Global.t ->
  written:Typing.Ir.definition ->
  Core.Ir.program ->
  Flow.Ir.program option
(** The program must have a bounded size, be causal and have no instantaneous loops; otherwise,
    reports errors that quote the sources, and returns [None]. If the request includes the drawing,
    the result has room for all of the program's marks. [written] is the entry as written in the
    source. *)

val lint : Flow.Ir.program -> unit
(** Checks the invariants of Flow between two stages. *)
