(** The message about two types of a signature that are in the wrong order. *)

open Basis
open Typing

val diagnostic : Wording.t -> Signature_fact.t -> Fact.t Facts.held list -> Diagnostic.t
(** The message has the code of the first of these mistakes, which the definition contains if the
    signature is right. If one of these mistakes is an equally likely explanation, returns the
    message about it instead. *)
