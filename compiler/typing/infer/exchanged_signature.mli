(** Two types of a signature in the wrong order.

    Finds out by checking the definition again against each signature with two types exchanged. *)

open Basis

type t
(** A signature with two types exchanged. *)

val candidates : Resolve.Ir.scheme -> t list
(** The exchanges that are likely mistakes: the input and the output of a signal function, a task or
    a program, two elements of a tuple, two parameters, and the parameter and the result. *)

val scheme : t -> Resolve.Ir.scheme

val fact :
  Source.t ->
  name:string ->
  Resolve.Ir.binding ->
  written:Resolve.Ir.scheme ->
  t ->
  mistake:Fact.t ->
  Signature_fact.t option
(** The definition of this name fits the exchanged signature, although [mistake] was found when it
    was checked against the written one. [None] if that mistake is the better explanation, or if the
    corrected signature is not in one line. *)
