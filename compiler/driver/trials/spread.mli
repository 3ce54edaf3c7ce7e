(** How far apart the values are that runs have measured. *)

val text : ?each:string -> name:string -> unit_:string -> (int * float) list -> string
(** Of values with their seeds; one that is not finite is none:
    [error: mean 0.05 m, deviation 0.01, from 0.04 (seed 3) to 0.07 (seed 7)]. [each] is what they
    are numbered by, instead of [seed]. The deviation is the standard deviation of the sample. *)
