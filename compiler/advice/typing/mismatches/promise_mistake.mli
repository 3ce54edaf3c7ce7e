(** Messages about definitions that require a class of a type variable although the context of their
    signature does not promise it ([E0309]). There is one message per signature, because the fix
    changes one line. *)

open Basis
open Typing

val unpromised : Wording.t -> Instance_fact.promise -> Instance_fact.promise list -> Diagnostic.t
(** All missing promises belong to the same signature. *)
