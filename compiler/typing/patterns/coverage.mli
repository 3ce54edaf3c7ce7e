(** Which values a list of patterns covers, and which of them are of use.

    The method is that of Maranget, {i Warnings for pattern matching} (2007), as one walk over the
    decision tree of the whole list: a leaf that no row reaches is a value not covered, and a row
    that no leaf reaches is of no use. *)

type t
(** The constructors of a program's data types. *)

val create : Ir.data list -> t

type row = {
  pattern : Ir.pattern;
  guarded : bool;  (** its guards may all fail, so it covers nothing *)
}

type missing = {
  named : string list;  (** some values, in source syntax, [_] for any; at least one *)
  more : int;  (** how many patterns as these there are besides *)
}

type result = {
  missing : missing option;  (** what is not covered *)
  guarded_only : int option;  (** a row that only its guards keep from the first of it *)
  useless : int list;  (** rows never reached, in order *)
}

val check : ?most:int -> t -> row list -> result
(** [most]: how many values are named, if there are so many; else 3. *)
