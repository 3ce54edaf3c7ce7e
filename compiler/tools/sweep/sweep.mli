(** [frobc sweep]: runs a trial many times, for combinations of worlds, robots, parameters and
    seeds. *)

type options = {
  jobs : int option;
      (** maximum number of concurrent processes; by default the number of processors *)
  shard : Runs.shard;  (** perform only the runs of this shard *)
  merge : bool;  (** perform no runs, and only write the table of existing rows *)
  dry : bool;  (** perform no runs, and only print their number *)
  rows : string option;  (** folder for the rows; [None] for a folder next to the plan *)
  also : string list;  (** additional folders with rows *)
  table : string option;  (** path of the table; [None] for a file next to the plan *)
  picture : string option;
}

val run : Common_options.t -> sources:string list -> options -> string -> int
(** Executes a plan file. If the sweep is interrupted, the same command continues it. The exit
    status is 0 if all runs were performed, whatever their results. *)
