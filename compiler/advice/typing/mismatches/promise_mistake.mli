(** Messages about definitions that need a class constraint on a type variable, although the context
    of their signature does not declare it ([E0309]). There is one message per signature, because
    the fix changes one line. *)

open Basis
open Typing

val unpromised : Wording.t -> Instance_fact.promise -> Instance_fact.promise list -> Diagnostic.t
(** All these constraints are missing from the same signature. *)
