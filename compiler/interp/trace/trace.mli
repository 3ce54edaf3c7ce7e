(** Runs an entry on recorded input: CSV in, CSV out.

    The first column is [time], in seconds with nine decimals. Each of the other columns contains
    one scalar, sum or event, and is named by its path ({!Shape.columns}). The first row is the
    first instant. *)

val run :
  ?marks:int ->
  ?params:Recorded_params.settings ->
  ?warn:(string -> unit) ->
  ?dialect:Dialect.t ->
  Core.Ir.program ->
  entry:Core.Ir.Global.t ->
  name:string ->
  read:(unit -> char option) ->
  write:(string -> unit) ->
  (unit, string list) result
(** - [marks]: add columns for up to this many marks of each drawing (default: none).
    - [params]: the values of parameters that override the recorded ones, which override the
      defaults.
    - [warn]: receives warnings about recorded parameters that are not used.
    - [dialect]: the dialect of the input (default: Frob's own).
    - [name]: name of the input, for messages.
    - [read]: returns the characters of the input; may raise [Sys_error].
    - [write]: called with each line of the output.

    The errors are messages for the user, each with file, line and column. *)

val nanoseconds : string -> int option
(** Converts the text of an instant's time, in seconds, to whole nanoseconds. The conversion is
    exact, and rounds ties away from zero. [None] if the text is not a number, or its absolute value
    exceeds 4 · 10^9 s. *)

val too_far : string -> string
(** A hint for the error message about a text that {!nanoseconds} rejects: says whether it exceeds
    the limit, and whether it looks like a time in a smaller unit. *)

val returns : string
(** The error message about a header with a carriage return that is not followed by a line feed. *)
