(** Checks patterns against the type of the matched value. A variable gets the type inferred for it,
    unless a signature has already determined its type. *)

val check : Context.t -> Resolve.Ir.pattern -> Expected.t -> Ir.pattern Context.later
