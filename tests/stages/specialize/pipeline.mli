(** Compiles a file to the Flow of its [main]. *)

open Basis

val flow :
  Diagnostic.sink ->
  Source.t ->
  files:Resolve.Files.t ->
  library:string ->
  string ->
  Flow.Ir.program option
