(** Runs an entry on recorded input: CSV in, CSV out.

    The first column is [time], in seconds, written with nine decimals; then comes one column for
    each scalar, sum or event, named by its path ({!Shape.columns}). The first row is the first
    instant. *)

val run :
  ?marks:int ->
  ?params:Recorded_params.settings ->
  ?warn:(string -> unit) ->
  Core.Ir.program ->
  entry:Core.Ir.Global.t ->
  name:string ->
  read:(unit -> char option) ->
  write:(string -> unit) ->
  (unit, string list) result
(** [marks]: with columns of so many marks that the program draws, at most (none). [params]: those
    that do not have the value that was recorded, or else the one by default; [warn] gets texts
    about others that were recorded. [name]: of the input, for messages. [read] gives its
    characters, and may raise [Sys_error]; [write] is called for each line of the output. The errors
    are texts for the user, each with file, line and column. *)

val nanoseconds : string -> int option
(** Seconds as an instant's time is written, in whole nanoseconds: exactly, halves away from zero.
*)
