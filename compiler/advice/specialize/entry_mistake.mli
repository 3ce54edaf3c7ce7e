(** Messages about programs that cannot run, because of a choice between programs ([E0411]), the
    type of an input, output or result ([E0412]), a function that depends on itself ([E0414]), or
    the rate of a node ([E0508]). *)

open Basis

val diagnostic : Specialize.Entry_fact.t -> Diagnostic.t
