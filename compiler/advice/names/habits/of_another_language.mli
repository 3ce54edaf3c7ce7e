(** Words and notations of other languages. *)

open Basis

val rules : (Unknown.t -> Diagnostic.t option) list
(** The rules in order of priority. *)

val controller : Unknown.t -> Diagnostic.t option
(** Suggests a controller with three gains as arguments. *)
