(** Messages about undefined units. *)

open Basis

val diagnostic : Unknown.t -> Diagnostic.t option
(** The error with a hint that applies only to units. [None] if there is no such hint; then the
    rules for all names apply. *)

val variable_of_letters : Unknown.t -> Diagnostic.t option
(** Explains a word in place of a unit variable, such as [Float[unit_of_x]]. *)

val of_variable : Resolve.Visible.t -> Syntax.Ir.name -> Diagnostic.t
(** Reports a unit variable where only a unit is allowed. *)
