(** [frobc trace]: runs a program on recorded input. *)

type engine = C  (** the compiled program *) | Interpreter

(** [dialect] is the dialect of the recording. [sources] are C files with functions that the program
    calls. *)

val trace :
  Common_options.t ->
  engine ->
  dialect:Interp.Dialect.t ->
  entry:string ->
  sources:string list ->
  modes:bool ->
  input:string option ->
  output:string option ->
  picture:string option ->
  string ->
  int
