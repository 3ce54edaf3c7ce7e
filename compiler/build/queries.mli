(** The questions that commands ask the compiler.

    Each query runs only the stages that its answer requires. It emits diagnostics to the sink, and
    adds the texts of the modules to the sources. An answer is [None] if the program was rejected,
    or if the request asks to stop after an earlier stage. *)

open Basis

type 'result t = Diagnostic.sink -> Source.t -> Request.t -> 'result

(** {1 Checks} *)

val check : ?seen:(Pipeline.tree -> unit) -> unit t
(** Runs all checks that can reject a program: on the module's [main] or, in a module without one,
    on each signal function that could be an entry. For [seen], see {!Pipeline.front}. *)

val partial : Source.t -> Request.t -> (Resolve.Ir.program * Typing.Ir.program Lazy.t) option
(** The resolved and typed parts of a program that contains mistakes, for editors. *)

(** {1 What a module declares} *)

val params : Params.set list option t
(** The parameters that the request sets, with their values. *)

val units_of_params : (string * string) list option t
(** The label and unit of each parameter. *)

val checks : Checks.t list option t
(** The tests and trials of the module. *)

(** {1 Signals of an entry} *)

val probes : string option t
(** The list of signals that users see ({!Probes.list}). *)

val columns : Columns.t list option t
(** The columns of a trace with all probes. *)

val measures : Measures.t list option t
(** The measures that a judge computes. *)

val origins : (Columns.t list * Probe.Origin.t list) option t
(** The same columns as {!columns}, and where their values come from. *)

(** {1 Programs for engines} *)

val flow : Flow.Ir.program option t
(** The entry as optimized equations. *)

val step : Step.Ir.program option t
(** The entry as state structs, reset functions and step functions. *)

val watched : (Step.Ir.program * Step.Ir.program option) option t
(** The program of {!step}, and, if that program has assertions, a second program that judges them.
*)

val compile : Cgen.Emit.t option t
(** The entry as C. *)

val interpretable : (Core.Ir.program * Core.Ir.Global.t * int) option t
(** The program, its entry and the number of marks to show, for the interpreter. *)

val for_both_engines : (Core.Ir.program * Core.Ir.Global.t * Cgen.Emit.t) option t
(** Both {!interpretable} and {!compile}, without compiling twice. *)
