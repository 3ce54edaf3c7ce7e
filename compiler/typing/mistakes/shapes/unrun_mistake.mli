(** A signal function where its output is expected ([E0303]). *)

open Basis

val unrun : Shape_fact.rule
(** A signal function where a value is expected. The hint shows how to run it, on an input signal of
    its input type if there is one, and how to convert its event if a truth value is expected. *)

val unrun_operand : Shape_fact.rule
(** Like {!unrun}, if the signal function is the other operand. *)

(** {1 Text about arguments} *)

val arguments_of : Resolve.Ir.expr -> Resolve.Ir.expr list
(** The arguments of an application, in order. *)

val count : int -> string
(** [two arguments] *)

val instead : Resolve.Ir.expr option -> string -> Diagnostic.t -> Diagnostic.t
(** Adds the fix that replaces the expression by this text. *)

val program_without_input : Shape_fact.rule
(** [reactimateRobot (proc () -> …)] where the program has an input. *)

val program_in_place_of_a_signal_function : Shape_fact.rule
(** A program with the type of a signal function. *)
