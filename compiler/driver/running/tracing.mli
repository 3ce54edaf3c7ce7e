(** [frobc trace]: a program on recorded input. *)

type engine = C  (** the compiled program *) | Interpreter

(** [sources]: the user's C files for a program that calls them. *)

val trace :
  General.t ->
  engine ->
  entry:string ->
  sources:string list ->
  modes:bool ->
  input:string option ->
  output:string option ->
  picture:string option ->
  string ->
  int
