(** Random programs through both engines, many in one compilation. *)

val size : int
(** How many programs a batch has at most. *)

type failure = {
  number : int;  (** of the program, for its seed *)
  recordings : Recording.t list;  (** its input, if it came so far *)
  outcome : Engines.outcome;
  text : string;
  real : Basis.Real.t;
}

val summary : seed:int -> failure -> string
(** In a line. *)

val describe : seed:int -> failure -> string
(** With the program and, if it differs, the recording: as NAME.frob and NAME.csv in
    [tests/meaning/interp] they are a test. *)

val first_failure :
  ?seen:Coverage.t ->
  Engines.tools ->
  Engines.c_engine list ->
  seed:int ->
  first:int ->
  count:int ->
  failure option
(** Only whether there is one: that of the whole batch, under its first number. *)

val shrunk : Engines.tools -> Engines.c_engine list -> seed:int -> failure -> failure
(** A small program that fails in the same way, if one is found in a minute. *)

val failures :
  ?seen:Coverage.t ->
  Engines.tools ->
  Engines.c_engine list ->
  seed:int ->
  first:int ->
  count:int ->
  failure list
(** Now and then the programs of a batch are tried one by one. If another batch fails, each of its
    programs is tried alone, and those that fail are given; if none does, the batch is, under its
    first number. *)
