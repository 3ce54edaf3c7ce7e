(** Records whose units depend on each other, such as the settings of a PID controller. *)

open Basis
open Typing

val relation : Environment.constructor -> string
(** Describes how the units of the fields are related. *)

val completed :
  Wording.t ->
  Environment.constructor ->
  Expected.completed ->
  (string * (Span.t * string) list) option
(** A hint that shows the whole record with a unit after each number, and the edits that apply the
    hint. *)
