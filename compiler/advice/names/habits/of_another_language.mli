(** Words and notations of other languages. *)

open Basis

val rules : (Unknown.t -> Diagnostic.t option) list
(** In the order of their priority. *)

val controller : Unknown.t -> Diagnostic.t option
(** A controller with three gains as arguments. *)
