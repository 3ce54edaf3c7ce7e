(** Messages about signals that need their own value in the same instant ([E0401]). *)

open Basis

val diagnostic : Source.t -> Flow.Fact.loop -> Diagnostic.t
(** The hints quote the sources. For a loop inside the library, the message shows the place in the
    program that uses it. *)
