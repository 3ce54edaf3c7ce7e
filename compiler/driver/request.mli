(** What is to be compiled, for which robot, and what is asked of the compiler. *)

open Basis

type t = {
  file : string;  (** of the program's main module *)
  entry : string;  (** the definition of it to compile *)
  library : string;  (** the folder of the standard library *)
  files : Resolve.Files.t;  (** where the texts of modules come from *)
  robot : Cgen.Robot.t option;
      (** for a program that leaves its robot open; see {!Robots.closed} *)
  real : Real.t;  (** the precision of [Float] *)
  probes : string list;  (** inner signals to be seen, as {!Probe.Selection} takes them *)
  asserts : bool;  (** the verdicts on its assertions are part of its output, for hosts *)
  margins : bool;  (** and how nearly each held: what the probes [margin] are *)
  params : Resolve.Parameters.setting list;  (** values for {!Pipeline.params} to tell *)
  batch : bool;  (** as for {!Cgen.Emit.program} *)
  specialization_limit : int;
  lint : bool;  (** check each stage's promises *)
  dump : Stage.t option;  (** print the program after this stage *)
  stop_after : Stage.t option;
}

val make : library:string -> string -> t
(** The [main] of a file, with nothing else asked for. *)

val own_robot : t -> Cgen.Robot.t option
(** The robot, if it is a user's own. *)

val stage :
  t ->
  Diagnostic.sink ->
  Stage.t ->
  lint:('a -> unit) ->
  print:(Format.formatter -> 'a -> unit) ->
  'a ->
  'a option
(** What happens after a stage: its promises are checked (they hold for programs without errors) and
    its result shown, if asked for; [None] with errors, or if it is the last one wanted. *)

val each_pass : t -> (Format.formatter -> 'program -> unit) -> 'program Pass.t -> 'program -> unit
(** If asked for: shows the program after each of a language's passes that changes it. *)
