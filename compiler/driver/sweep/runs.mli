(** The runs of a sweep, numbered, and made by several processes. *)

type run = {
  place : Setup.place;
  point : string array;
  seed : int;
  key : string;  (** a digest of all that the run depends on *)
}

val count : Setup.t -> int

val run : Setup.t -> int -> run
(** By its number, from 0: worlds, then robots, then points, then seeds, which vary fastest. *)

type shard = { number : int; of_ : int }
(** of so many, from 1 *)

val missing : Setup.t -> shard -> Rows.t -> int list
(** Of the shard's runs those that there is no row of, in their order. *)

val make :
  Setup.t -> Resources.t -> jobs:int -> folder:string -> Rows.t -> int list -> (unit, string) result
(** Makes these, so many at a time, with rows in files of the folder. A process that is killed has
    its runs made by another. The error says why they cannot go on; rows that are there stay. *)
