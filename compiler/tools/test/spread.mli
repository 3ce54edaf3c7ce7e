(** The distribution of measured values. *)

val text : ?each:string -> name:string -> unit_:string -> (int * float) list -> string
(** Summarizes values with their seeds, ignoring those that are not finite:
    [error: mean 0.05 m, deviation 0.01, from 0.04 (seed 3) to 0.07 (seed 7)]. [each] replaces the
    word [seed]. The deviation is the standard deviation of the sample. *)
