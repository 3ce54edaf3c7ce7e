(** The message about two types of a signature that are in the wrong order. *)

open Basis
open Typing

val diagnostic : Wording.t -> Signature_fact.t -> Fact.t Facts.held list -> Diagnostic.t
(** The mistakes are those that the definition contains if the signature is right. The message has
    the code of the first one. If one of them is an equally likely explanation, returns the message
    about that mistake instead. *)
