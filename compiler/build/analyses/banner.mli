(** The lines at the top of generated C that say how to regenerate it. *)

val lines : Request.t -> Basis.Source.t -> string list
(** The version of frobc, the options that change the generated C, and the MD5 sum of each source
    file, as [md5sum] prints it. All modules of the library share one sum. The lines do not depend
    on the folder, the machine or the time. *)
