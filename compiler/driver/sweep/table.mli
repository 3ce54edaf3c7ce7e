(** The rows of a sweep as one table, CSV. *)

type fate = { held : bool; void : bool }

val csv : Setup.t -> Rows.t -> string
(** A row for each run, in their order, of which all are there: its number, world, robot,
    parameters, seed, what became of it, when and by what, where the robot was, and what was
    measured. *)

val fate : string list -> fate
(** Of a run's cells. *)

val measured : Setup.t -> string list -> Measures.t -> float
(** What a run has measured, of its cells; NaN for nothing. *)
