(** Checks patterns against the type of the matched value. A variable gets the type found for it,
    unless a signature has already given it one. *)

val check : Context.t -> Resolve.Ir.pattern -> Expected.t -> Ir.pattern Context.later
