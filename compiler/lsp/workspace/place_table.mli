(** Hash tables whose keys are places in one text. *)

open Basis
include Hashtbl.S with type key = Span.position * Span.position

val place : Span.t -> key
