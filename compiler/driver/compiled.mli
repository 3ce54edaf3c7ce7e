(** A file compiled as far as a command needs it, or the user told why not. *)

val accepted :
  ?quiet:bool ->
  (Basis.Diagnostic.sink -> Basis.Source.t -> Request.t -> 'result option) ->
  General.t ->
  ?batch:bool ->
  Resources.t ->
  entry:string ->
  string ->
  (Request.t -> 'result -> int) ->
  int
(** Goes on with what a pipeline gives, or gives the status with which to end. *)

val to_c :
  ?quiet:bool ->
  ?batch:bool ->
  General.t ->
  Resources.t ->
  entry:string ->
  string ->
  (Cgen.Emit.t -> int) ->
  int
(** Compiles a file to C and goes on with it; tells what is wrong with it otherwise. [quiet]: only
    errors are told, no warnings. *)

val robot_header : Resources.t -> Robots.t -> (string * string, string) result
(** Its name and text, or a text for the user. *)

val header_of : Resources.t -> Robots.t -> string option * Basis.Diagnostic.sink * Basis.Source.t
(** The text of the header with its types, and what was said of its module. *)
