(** Messages about a program's entry point: a definition that does not exist ([E0501]) or cannot run
    ([E0411]). They show the definition's type as the user wrote it, or as it was inferred. *)

open Basis

val diagnostic : Typing.Entry_fact.t -> Diagnostic.t

val no_entry : string
(** The code of the error for an entry point that does not exist. *)
