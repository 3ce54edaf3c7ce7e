(** Rules for a signal function where its output is expected ([E0303]). *)

open Basis

val unrun : Shape_fact.rule
(** A signal function where a value is expected. The hint shows how to run it, if possible on an
    input signal of the right type. If the output is an event and a truth value is expected, the
    hint also converts the event. *)

val unrun_operand : Shape_fact.rule
(** Like {!unrun}, if the signal function is the other operand. *)

(** {1 Text about arguments} *)

val arguments_of : Resolve.Ir.expr -> Resolve.Ir.expr list
(** The arguments of an application, in source order. *)

val count : int -> string
(** [two arguments] *)

val signal_for : Wording.t -> Typing.Type.t -> string
(** An expression for a signal of this type, or `()` if the type can be anything. *)

val instead : Resolve.Ir.expr option -> string -> Diagnostic.t -> Diagnostic.t
(** Adds the fix that replaces the expression with this text. *)

val program_without_input : Shape_fact.rule
(** [reactimateRobot (proc () -> …)] where the program has an input. *)

val program_in_place_of_a_signal_function : Shape_fact.rule
(** A program where a signal function is expected. *)
