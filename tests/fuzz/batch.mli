(** Random programs through both engines, many in one compilation. *)

val size : int
(** How many programs a batch has at most. *)

type failure = {
  number : int;  (** of the program, for its seed *)
  outcome : Engines.outcome;
  text : string;
}

val summary : seed:int -> failure -> string
(** In a line. *)

val describe : seed:int -> failure -> string
(** With the program. *)

val failure :
  Engines.tools -> Engines.c_engine list -> seed:int -> first:int -> count:int -> failure option
(** Of the whole batch, under its first number. *)

val failures :
  Engines.tools -> Engines.c_engine list -> seed:int -> first:int -> count:int -> failure list
(** If the batch fails, each of its programs is tried alone, and those that
    fail are given; if none does, the batch is, under its first number. *)
