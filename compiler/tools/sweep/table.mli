(** Formats the results of a sweep as one CSV table. *)

type fate = { held : bool; void : bool }

val csv : Setup.t -> Rows.t -> string
(** Writes one row for each run, in order. All runs must be complete. The columns are the run's
    number, world, robot, parameters and seed, the run's outcome with its time and cause, the
    robot's final position, and the measurements. *)

val fate : string list -> fate
(** Parses a run's outcome from its cells. *)

val measured : Setup.t -> string list -> Measures.t -> float
(** The measurement in a run's cells; NaN if there is none. *)
