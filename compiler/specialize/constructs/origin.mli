(** Where and under which name the programmer knows what a machine or one of its modes runs. *)

open Basis

val place : otherwise:Span.t -> Value.t -> Span.t
(** Of a signal function, or of what a continuation gives. *)

val name : Value.t -> string
(** Of a machine, by what it is made of. *)

val mode_name : Value.t -> string
(** Of a mode, by its signal function; of a task, by what runs first in it. *)

val mode_place : otherwise:Span.t -> Value.t -> Span.t
(** Likewise. *)
