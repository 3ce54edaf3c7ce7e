(** Messages about words and notations from other languages. *)

open Basis

val rules : (Unknown.t -> Diagnostic.t option) list
(** The rules in order of priority. *)

val controller : Unknown.t -> Diagnostic.t option
(** Suggests [pid] in place of another library's controller that is applied to three gains and an
    error. *)
