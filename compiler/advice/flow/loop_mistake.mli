(** Messages about signals that need their own value in the same instant ([E0401]). *)

open Basis

val diagnostic : Source.t -> Flow.Fact.loop -> Diagnostic.t
(** The hints quote the sources. A loop inside the library is reported where the program uses the
    library. *)
