(** Golden traces: what the program gives on an input is what it once gave. *)

val run : Checking.t -> string -> Checks.t -> input:string -> output:string -> Outcome.t
(** The files are found from the folder of the program. With [update] the output is written where it
    has changed, or is not there yet. *)
