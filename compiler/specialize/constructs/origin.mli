(** The source places and names of the signal functions that a machine or its modes run. *)

open Basis

val place : otherwise:Span.t -> Value.t -> Span.t
(** The source place of a signal function, or of the result of a continuation. *)

val name : Value.t -> string
(** The name of a machine, taken from its signal function. *)

val mode_name : Value.t -> string
(** The name of a mode, taken from its signal function; for a task, from the task that runs first.
*)

val mode_place : otherwise:Span.t -> Value.t -> Span.t
(** The place of a mode, determined like {!mode_name}. *)
