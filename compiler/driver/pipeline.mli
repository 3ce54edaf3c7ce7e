(** The compiler from end to end: which stage follows which, and why. *)

open Basis

type options = {
  dump : Stage.t option;  (** print the program after this stage *)
  stop_after : Stage.t option;
  lint : bool;  (** check each stage's promises *)
  specialization_limit : int;
  real : Real.t;  (** the precision of [Float] *)
}

val check : ?robot:Cgen.Robot.t -> options -> Diagnostic.sink -> Source.t -> library:string -> string -> unit
(** [check options sink sources ~library file]: all that can reject a program, of its `main`
    or, in a module without one, of each signal function that could be an entry; what there
    is to say goes to the sink. *)

val no_entry : string
(** The code of the diagnostic for an entry that the module does not define. *)

val no_interpreter : string
(** The code of the diagnostic for a program that the interpreter cannot run. *)

val machine :
  ?robot:Cgen.Robot.t ->
  options ->
  Diagnostic.sink ->
  Source.t ->
  library:string ->
  entry:string ->
  string ->
  Machine.Ir.program option
(** For one entry of the file's module, everything before C. A program that
    leaves its robot open is one for [robot]; see {!Robots.closed}. [None] if the
    program was rejected, or if [stop_after] came first. *)

val compile :
  ?batch:bool ->
  ?robot:Cgen.Robot.t ->
  options ->
  Diagnostic.sink ->
  Source.t ->
  library:string ->
  entry:string ->
  string ->
  Cgen.Emit.t option
(** The whole chain, for one entry of the file's module; [batch] as for {!Cgen.Emit.program}.
    [None] if the program was rejected, or if [stop_after] came first. *)

val interpretable :
  ?robot:Cgen.Robot.t ->
  options ->
  Diagnostic.sink ->
  Source.t ->
  library:string ->
  entry:string ->
  string ->
  (Core.Ir.program * Core.Ir.Global.t) option
(** The program and its entry, for the interpreter: everything that can reject
    a program has looked at it. [None] as for {!compile}. *)

val for_both_engines :
  ?robot:Cgen.Robot.t ->
  options ->
  Diagnostic.sink ->
  Source.t ->
  library:string ->
  entry:string ->
  string ->
  (Core.Ir.program * Core.Ir.Global.t * Cgen.Emit.t) option
(** What {!interpretable} and {!compile} give, with one run of the stages that
    they share. *)

val robot_header : Diagnostic.sink -> Source.t -> library:string -> Cgen.Robot.t -> string option
(** The C header with the input and output structs of a robot, from the types
    in its module of the library, which defines the entry [atRest] on them. *)
