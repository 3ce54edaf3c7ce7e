(** Recognizes signatures in which two types are in the wrong order.

    Inference checks the definition again against each candidate, that is, the signature with two
    types exchanged. *)

open Basis

type t
(** A signature with two types exchanged. *)

val candidates : Resolve.Ir.scheme -> t list
(** The exchanges that programmers are likely to make by mistake: the input and the output of a
    signal function, task or program; two elements of a tuple; two parameters; or the last parameter
    and the result. *)

val scheme : t -> Resolve.Ir.scheme

val fact :
  Source.t ->
  name:string ->
  Resolve.Ir.binding ->
  written:Resolve.Ir.scheme ->
  t ->
  mistake:Fact.t ->
  Signature_fact.t option
(** The fact to report for the definition with this name, which fits the exchanged signature.
    [mistake]: the mistake reported for the written signature. [None] if [mistake] is the better
    explanation, or if the corrected signature is not on one line. *)
