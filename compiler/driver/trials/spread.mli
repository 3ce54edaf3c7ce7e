(** How far apart the values are that runs have measured. *)

val text : name:string -> unit_:string -> (int * float) list -> string
(** Of values with their seeds, of which NaN is none: [error: mean 0.05 m, deviation 0.01, from
    0.04 (seed 3) to 0.07 (seed 7)]. The deviation is the standard deviation of the sample. *)
