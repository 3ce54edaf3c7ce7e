(** The compiler from end to end: which stage follows which, and why.

    What is wrong with a program goes to the sink, the text of its modules to the sources. A result
    is [None] if the program was rejected, or if [stop_after] came first. *)

open Basis

type 'result t := Diagnostic.sink -> Source.t -> Request.t -> 'result

val check : unit t
(** All that can reject a program, of its `main` or, in a module without one, of each signal
    function that could be an entry. *)

val params : Params.set list option t
(** What the request sets parameters to. *)

val units_of_params : (string * string) list option t
(** Of each parameter, by its label. *)

val checks : Checks.t list option t
(** The tests and trials in the file's module. *)

val flow : Flow.Ir.program option t
(** One entry of the file's module, before there is a state struct and a step. *)

val step : Step.Ir.program option t
(** Everything before C. *)

val watched : (Step.Ir.program * Step.Ir.program option) option t
(** Likewise; and once more with its assertions judged, if it asserts anything. *)

val compile : Cgen.Emit.t option t
(** The whole chain. *)

val interpretable : (Core.Ir.program * Core.Ir.Global.t * int) option t
(** The program and its entry, for the interpreter, and how many marks it is to show: everything
    that can reject a program has looked at it. *)

val probes : string option t
(** What of the program can be seen ({!Probes.list}). *)

val columns : Columns.t list option t
(** What is known of the columns of a trace with all probes. *)

val measures : Measures.t list option t
(** What a judge measures. *)

val origins : (Columns.t list * Probe.Origin.t list) option t
(** That, and where their values come from. *)

val for_both_engines : (Core.Ir.program * Core.Ir.Global.t * Cgen.Emit.t) option t
(** What {!interpretable} and {!compile} give, with one run of the stages that they share. *)
