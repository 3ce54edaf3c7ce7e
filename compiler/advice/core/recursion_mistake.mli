(** Messages about definitions that depend on themselves: directly or through others ([E0410]), at
    too many or ever larger types ([E0413]), or in a continuation at a larger type ([E0417]). *)

open Basis

val diagnostic : Core.Fact.t -> Diagnostic.t
