(** The message about two types in a signature that are in the wrong order. *)

open Basis
open Typing

val diagnostic : Wording.t -> Signature_fact.t -> Fact.t Facts.held list -> Diagnostic.t
(** The list contains the mistakes in the definition, assuming that the signature is right. The
    message has the code of the first mistake. If a mistake in the definition is an equally likely
    explanation, returns the message about that mistake instead. *)
