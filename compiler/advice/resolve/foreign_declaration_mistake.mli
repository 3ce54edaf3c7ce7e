(** Messages about foreign declarations: names that are not valid in C, and headers that are missing
    or in the wrong folder. *)

open Basis

val diagnostic : Resolve.Fact.in_foreign_code -> Diagnostic.t
