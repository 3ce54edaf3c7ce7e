(** Finds the installed files: in [FROB_HOME], or relative to the [frobc] executable, which is part
    of an installation or of a build. *)

val find : unit -> (Resources.t, string) result
(** The error lists the places that were searched, and says what to do. *)
