(** Runs random programs in both engines, many in one compilation. *)

val size : int
(** Maximum number of programs in a batch. *)

type failure = {
  number : int;  (** index of the program for its seed *)
  recordings : Recording.t list;  (** its input, if the test reached the point of generating it *)
  outcome : Engines.outcome;
  text : string;
  real : Basis.Real.t;
}

val summary : seed:int -> failure -> string
(** A description in one line. *)

val describe : seed:int -> failure -> string
(** A description with the program and, if the engines differ, the recording. If they are saved as
    NAME.frob and NAME.csv in [tests/meaning/interp], they become a test. *)

val first_failure :
  ?seen:Coverage.t ->
  Engines.tools ->
  Engines.c_engine list ->
  seed:int ->
  first:int ->
  count:int ->
  failure option
(** Only determines whether there is a failure. A failure of the whole batch is reported under its
    first number. *)

val shrunk : Engines.tools -> Engines.c_engine list -> seed:int -> failure -> failure
(** Searches for up to a minute for a small program that fails in the same way. *)

val failures :
  ?seen:Coverage.t ->
  Engines.tools ->
  Engines.c_engine list ->
  seed:int ->
  first:int ->
  count:int ->
  failure list
(** Compiles the programs of some batches one by one, and the others together. If a batch fails,
    tests each of its programs alone and returns those that fail; if none does, returns the failure
    of the batch under its first number. *)
