(** Finds the files of the installation, relative to [frobc], in an installation or a build, or in
    [FROB_HOME]. *)

val find : unit -> (Resources.t, string) result
(** The error lists the places that were searched, and says what to do. *)
