(** [frobc sweep]: runs a trial many times, for combinations of worlds, robots, parameters and
    seeds. *)

type options = {
  jobs : int option;
      (** maximum number of concurrent processes; by default the number of processors *)
  shard : Runs.shard;  (** makes only these runs *)
  merge : bool;  (** makes no runs, only the table of existing rows *)
  dry : bool;  (** makes no runs, only prints their number *)
  rows : string option;  (** folder for rows; [None] for one next to the plan *)
  also : string list;  (** additional folders with rows *)
  table : string option;  (** path of the table; [None] for one next to the plan *)
  picture : string option;
}

val run : Common_options.t -> sources:string list -> options -> string -> int
(** Executes a plan file. If it is interrupted, the same command continues from there. The exit
    status is 0 if all runs were made, whatever their results. *)
