(** Compiles a file as far as a command requires, or reports why it cannot be compiled. *)

val accepted :
  ?quiet:bool ->
  ?banner:bool ->
  'result option Queries.t ->
  Common_options.t ->
  ?batch:bool ->
  Resources.t ->
  entry:string ->
  string ->
  (Request.t -> 'result -> int) ->
  int
(** Continues with the result of a query. If there is no result, prints the reason and returns the
    exit status. [quiet] suppresses warnings, because another call has already printed them. *)

val to_c :
  ?quiet:bool ->
  ?batch:bool ->
  ?banner:bool ->
  Common_options.t ->
  Resources.t ->
  entry:string ->
  string ->
  (Cgen.Emit.t -> int) ->
  int
(** Compiles a file to C and continues with the result, or reports the errors. [quiet] suppresses
    warnings. *)

val robot_header : Resources.t -> Robots.t -> (string * string, string) result
(** The name and text of the header. The error is a message for the user. *)

val header_of : Resources.t -> Robots.t -> string option * Basis.Diagnostic.sink * Basis.Source.t
(** The header's text, and the diagnostics for the robot's module. *)

val with_params :
  Common_options.t -> Resources.t -> entry:string -> string -> (Params.set list -> int) -> int
(** Continues with the parameter values from the command line. Reports invalid values as usage
    errors. *)
