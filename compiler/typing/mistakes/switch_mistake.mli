(** What goes wrong in the arguments of [switch], [dSwitch] and [mkTask]: one mode, which gives its
    output beside the event that ends it, and what goes on from the event's value. *)

open Basis

val of_a_mode :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  found:Type.t ->
  string option
(** The cure where something else stands in the place of the mode. *)

val goes_on : Expected.t -> bool
(** A function of a value is wanted, as by a switch of its event's. *)

val three_arguments :
  Show.words ->
  name:string ->
  at:Span.t ->
  (Resolve.Ir.expr * Type.t) list ->
  Diagnostic.t ->
  Diagnostic.t
(** [switch mode event next], as other languages have it, with the types of the arguments: what is
    said of it instead. *)
