(** The message about two types of a signature in the wrong order. *)

open Basis
open Typing

val diagnostic : Show.words -> Signature_fact.t -> Fact.t Facts.held list -> Diagnostic.t
(** It has the code of the first of these mistakes, which the definition has if the signature is
    right. If one of them is as likely, returns the message about it. *)
