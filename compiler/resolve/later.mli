(** Names of the language reference that this version does not have yet. *)

val is_name : string -> bool
