(** The compiler's stages in order, from text to C. {!Queries} combines them into answers for
    commands.

    A stage emits diagnostics to the sink. Its result is [None] if the program was rejected, or if
    the request asks to stop after this stage. *)

open Basis

(** {1 From text to Core} *)

type front = {
  resolved : Resolve.Ir.program;  (** includes all definitions of the library *)
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  margin : Span.t -> Core.Formula.t option;
      (** if the request includes margins: the formula that measures how far the assertion at this
          place is from being violated *)
}

(** The results that remain valid even if a later stage fails. *)
type tree = Resolved of Resolve.Ir.program | Typed of Typing.Ir.program

val front : ?seen:(tree -> unit) -> Request.t -> Diagnostic.sink -> Source.t -> front option
(** Parses, resolves and types the modules and elaborates them to Core. Adds their texts to the
    sources, and passes each tree to [seen] as soon as it exists. *)

val reachable : Resolve.Ir.program -> Resolve.Ir.program
(** The program without the library definitions that it cannot reach. *)

(** {1 From Core to Flow} *)

val to_flow :
  Request.t ->
  Diagnostic.sink ->
  Source.t ->
  front ->
  written:Typing.Ir.definition ->
  Core.Ir.program * Core.Ir.Global.t ->
  ((Core.Ir.program * Core.Ir.Global.t) * Flow.Ir.program) option
(** Finds the controls of the console, specializes the entry and checks causality. The messages
    quote the sources. [written] is the entry as written in the source. The last argument is the
    program for a specific robot, with its entry. The result contains this program, with the
    console's fields added. *)

(** {1 From Flow to C} *)

val optimize : Request.t -> Diagnostic.sink -> Flow.Ir.program -> Flow.Ir.program option

val lower : Request.t -> Diagnostic.sink -> Flow.Ir.program -> Step.Ir.program option
(** Translates an optimized program to state structs, reset functions and step functions. *)

val emit :
  Request.t ->
  Diagnostic.sink ->
  Source.t ->
  units:Cgen.Units.t ->
  named:Cgen.Named_constants.t ->
  ?node:Cgen.Node_table.t ->
  Step.Ir.program ->
  Cgen.Emit.t option
(** [units]: the units to state in the comments of struct members; [named]: the constants that keep
    their names in C; [node]: the topics, if the program is a ROS 2 node. *)
