(** Golden traces: the program's output for an input must equal the stored output. *)

val run : Session.t -> string -> Checks.t -> input:string -> output:string -> Outcome.t
(** Paths are relative to the folder of the program. If the option [update] is set, writes the
    output if it differs or if the file does not exist yet. *)
