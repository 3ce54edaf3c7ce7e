(** The order in which a step writes its state, such that everything that
    reads a field reads the old value.

    Writes that hang on one condition form a unit, one [If]. A unit comes
    before another if it reads what the other writes; what it reads counts
    through all values that nothing else needs, because those may be computed
    inside it. Where units read each other's fields in a circle (an exchange),
    one of them gets its values before all writes. *)

open Basis

type unit_ = {
  writes : writes;
  early : bool;  (** its values are computed before all units *)
}

and writes =
  | Always of write
  | By of { condition : Fragment.atom; then_ : write list; else_ : write list; span : Span.t }

and write = {
  write : Fragment.write;
  early : bool;  (** its values are computed at the start of its block *)
}

val of_usage : Usage.t -> unit_ list

val reads : Usage.t -> Fragment.atom list -> unit Int_table.t
(** The fields that are read for these values when they are computed as late
    as possible. *)

val atoms : Fragment.update -> Fragment.atom list
