(** Which values a list of patterns covers, and which of them are of use.

    The method is that of Maranget, {i Warnings for pattern matching} (2007),
    as one walk over the decision tree of the whole list: a leaf that no row
    reaches is a value not covered, and a row that no leaf reaches is of no
    use. *)

type t
(** The constructors of a program's data types. *)

val create : Ir.data list -> t

type row = {
  pattern : Ir.pattern;
  guarded : bool;  (** its guards may all fail, so it covers nothing *)
}

type result = {
  missing : string option;  (** a value not covered, in source syntax *)
  guarded_only : int option;  (** a row that only its guards keep from it *)
  useless : int list;  (** rows never reached, in order *)
}

val check : t -> row list -> result
