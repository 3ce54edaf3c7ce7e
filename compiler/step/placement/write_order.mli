(** Orders the writes of a step's state. The writes are in the order of the fields. Every value must
    be computed from the old contents of the fields, so a write is [Early] if its value depends on a
    field that is written before it.

    If only this write, or the writes that share its [If], need an intermediate value, that value is
    computed as late as possible, so the fields that the intermediate value reads count too. *)

type timing =
  | In_order
  | Early_condition  (** only its condition is computed before all writes *)
  | Early  (** its values are computed before all writes *)

type write = { write : Fragment.write; timing : timing }

val of_usage : Usage.t -> write list

val written : write list -> Fragment.atom -> Usage.t -> bool
(** Whether the value depends on a field that one of these writes changes. *)
