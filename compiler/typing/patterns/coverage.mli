(** Checks which values a list of patterns covers, and which patterns are useless.

    The method is that of Maranget, {i Warnings for pattern matching} (2007), as one walk over the
    decision tree of the whole list. A leaf that no row reaches is an uncovered value. A row that
    reaches no leaf is useless. *)

type t
(** The constructors of the program's data types. *)

val create : Ir.data list -> t

type row = {
  pattern : Ir.pattern;
  guarded : bool;  (** whether all its guards may fail; if so, the row covers nothing *)
}

type missing = Pattern_fact.missing = { named : string list; more : int }

type result = {
  missing : missing option;  (** the uncovered values *)
  guarded_only : int option;
      (** the index of a row that would cover the first uncovered value if the row had no guards *)
  useless : int list;  (** unreachable rows, in order *)
}

val check : ?most:int -> t -> row list -> result
(** [most]: the maximum number of values to list; 3 by default. *)
