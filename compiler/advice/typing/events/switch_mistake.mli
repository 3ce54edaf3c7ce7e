(** Hints about the arguments of [switch], [dSwitch] and [mkTask]. The first argument is a mode,
    which returns its output and the event that ends it. The second argument of a switch is a
    function from the event's value to the next mode. *)

open Basis
open Typing

val mode : Shape_fact.rule
(** A value of another type where a mode is expected. *)

val with_an_event : string -> string
(** The pair of this output and an event. *)

val ends_it : string -> string
(** The hint that shows how to end a mode: return this output paired with an event. *)

val goes_on : Expected.t -> bool
(** Does the context expect a function that takes the event's value and returns the next mode? *)

val three_arguments :
  Wording.t -> name:string -> at:Span.t -> (Resolve.Ir.expr * Type.t) list -> Diagnostic.t option
(** The message about [switch mode event next], which uses the argument order of other languages.
    The list contains the arguments with their types. *)

val input_as_pair : Shape_fact.rule
(** A switch whose first mode returns only its input. *)

val output_without_event : Shape_fact.rule
(** The output of a mode without the event that ends it. *)

val next_mode : Shape_fact.rule
(** A condition or another function in place of the function that returns the next mode. *)
