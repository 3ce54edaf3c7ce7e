(** Golden traces: the program's output for an input must equal the stored output. *)

val run : Session.t -> string -> Checks.t -> input:string -> output:string -> Outcome.t
(** Paths are relative to the folder of the program. With the option [update], writes the output to
    its file unless the file already contains it. *)
