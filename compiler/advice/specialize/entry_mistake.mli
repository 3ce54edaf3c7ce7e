(** Messages about programs that cannot run: the choice between programs ([E0411]), the types of
    their input and output ([E0412]), functions that depend on themselves ([E0414]), and the rate of
    a node ([E0508]). *)

open Basis

val diagnostic : Specialize.Entry_fact.t -> Diagnostic.t
