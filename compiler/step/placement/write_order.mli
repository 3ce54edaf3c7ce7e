(** The order in which a step writes its state: the order of the fields. Since every value must be
    computed from the old contents of fields, a write is [Early] if its value depends on a field
    that is written before it.

    The value depends on a field even if the field is read for an intermediate value that only this
    write, or the writes that share its [If], need. Such values are computed as late as possible. *)

type timing =
  | In_order
  | Early_condition  (** only its condition is computed before all writes *)
  | Early  (** its values are computed before all writes *)

type write = { write : Fragment.write; timing : timing }

val of_usage : Usage.t -> write list

val written : write list -> Fragment.atom -> Usage.t -> bool
(** Whether the value depends on a field that these writes change. *)
