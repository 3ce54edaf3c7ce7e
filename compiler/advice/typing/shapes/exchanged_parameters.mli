(** Functions whose two parameters are in the other order than the one in which they are passed,
    such as [foldl step 0 xs] with [step :: Element -> Int -> Int]. *)

open Basis
open Typing

val order : string -> string
(** The order in which this function passes its arguments to a function of the user. *)

val diagnostic :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Diagnostic.t option
