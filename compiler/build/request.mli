(** A request to compile an entry of a file for a robot, with options. *)

open Basis

type t = {
  options : Common_options.t;
  file : string;  (** source file of the program's main module *)
  entry : string;  (** the definition in [file] to compile *)
  library : string;  (** the folder of the standard library *)
  files : Resolve.Files.t;  (** reads the texts of modules *)
  robot : Cgen.Robot.t option;  (** the robot that the options name; see {!Robots.closed} *)
  settings : Resolve.Parameters.setting list;  (** values of parameters, for {!Queries.params} *)
  batch : bool;  (** see {!Cgen.Emit.program} *)
  banner : bool;  (** whether the generated C begins with {!Banner.lines} *)
}

val make :
  ?options:Common_options.t ->
  ?robot:Cgen.Robot.t ->
  ?entry:string ->
  ?batch:bool ->
  ?banner:bool ->
  library:string ->
  string ->
  t
(** A request for the entry of a file, by default its [main]. *)

val own_robot : t -> Cgen.Robot.t option
(** The robot, if it is user-defined. *)

val judges : t -> bool
(** Whether the verdicts on assertions are part of the output, for hosts. *)

val measures_margins : t -> bool
(** Whether the output also states how far each assertion was from being violated. *)

val probes : t -> string list
(** The probes that the options request, and those that margins need. *)

val stage :
  t ->
  Diagnostic.sink ->
  Stage.t ->
  lint:('a -> unit) ->
  print:(Format.formatter -> 'a -> unit) ->
  'a ->
  'a option
(** Finishes a stage. If the options request it, checks the invariants of the result (only if there
    were no errors) and prints the result. Returns [None] if there were errors, or if the options
    end the compilation after this stage. *)

val each_pass : t -> (Format.formatter -> 'program -> unit) -> 'program Pass.t -> 'program -> unit
(** Prints the program after each pass that changes it, if the options request it. *)
