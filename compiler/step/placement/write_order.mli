(** Orders a step's writes to its state. They follow the order of the fields. Every value must be
    computed from the old contents of the fields, so a write is [Early] if its value depends on a
    field that is written earlier.

    This includes fields that are read by intermediate values needed only by this write or by the
    writes that share its [If], because these values are computed as late as possible. *)

type timing =
  | In_order
  | Early_condition  (** only its condition is computed before all writes *)
  | Early  (** its values are computed before all writes *)

type write = { write : Fragment.write; timing : timing }

val of_usage : Usage.t -> write list

val written : write list -> Fragment.atom -> Usage.t -> bool
(** Whether the value depends on a field that one of these writes changes. *)
