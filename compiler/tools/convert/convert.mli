(** [frobc convert]: converts recordings to MCAP and back, and changes their compression. *)

val run : Interp.Dialect.t -> string -> string -> int
(** [run dialect from path] converts the recording [from] to [path] and returns the exit status.
    [dialect] is the dialect of [from]. The file extensions determine the formats. *)
