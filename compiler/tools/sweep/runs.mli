(** The numbered runs of a sweep, which several processes perform. *)

type run = {
  place : Setup.place;
  point : string array;
  seed : int;
  key : string;  (** a digest of everything that the run depends on *)
}

val count : Setup.t -> int

val run : Setup.t -> int -> run
(** The run with this number, from 0. Seeds vary fastest, then points, then robots, then worlds. *)

type shard = { number : int; of_ : int }
(** One of [of_] shards, numbered from 1. *)

val missing : Setup.t -> shard -> Rows.t -> int list
(** The numbers of the shard's runs that have no row yet, in order. *)

val make :
  Setup.t -> Resources.t -> jobs:int -> folder:string -> Rows.t -> int list -> (unit, string) result
(** Performs these runs with up to [jobs] processes, which write rows to files in the folder. If a
    process is killed, another one performs its runs. The error says why the runs stopped. The rows
    that exist by then are kept. *)
