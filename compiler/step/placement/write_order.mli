(** The order in which a step writes its state: the order of the fields. Since every value must be
    computed from the old contents of fields, a write is [early] if its value depends on a field
    that is written before it.

    The dependency includes all intermediate values that only this write, or the writes that share
    its [If], need, because these are computed as late as possible. *)

type write = {
  write : Fragment.write;
  early : bool;  (** its values are computed before all writes *)
}

val of_usage : Usage.t -> write list

val written : write list -> Fragment.atom -> Usage.t -> bool
(** Whether the value depends on a field that these writes change. *)
