(** [frobc sweep]: many runs of a trial, over worlds, robots, parameters and seeds. *)

type options = {
  jobs : int option;  (** so many processes at a time; as many as there are processors *)
  shard : Runs.shard;  (** only these runs *)
  merge : bool;  (** no runs: the table of the rows that are there *)
  dry : bool;  (** nothing is made: how many runs there are is told *)
  rows : string option;  (** the folder for rows; beside the plan if [None] *)
  also : string list;  (** more folders with rows *)
  table : string option;  (** beside the plan if [None] *)
  picture : string option;
}

val run : General.t -> sources:string list -> options -> string -> int
(** Of the file of a plan. Whatever ends it, the same command goes on where it ended. Exit status 0
    if all its runs are done, whatever became of them. *)
