(** Two types of a signature in the wrong order.

    Finds out by checking the definition again against each signature with two types exchanged. *)

open Basis

type t
(** A signature with two types exchanged. *)

val candidates : Resolve.Ir.scheme -> t list
(** The exchanges that are likely mistakes: the input and the output of a signal function, a task or
    a program, two elements of a tuple, two parameters, and the parameter and the result. *)

val scheme : t -> Resolve.Ir.scheme

val explain :
  Source.t ->
  name:string ->
  Resolve.Ir.binding ->
  written:Resolve.Ir.scheme ->
  t ->
  Diagnostic.t list ->
  Diagnostic.t option
(** The message about the definition of this name, which fits the exchanged signature, in place of
    those that checking it against the written signature reported. [None] if these are better. *)
