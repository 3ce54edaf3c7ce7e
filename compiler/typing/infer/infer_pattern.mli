(** Patterns against the type of what they match. Their variables get the types found for them,
    unless a signature has given them one before. *)

val check : Context.t -> Resolve.Ir.pattern -> Expected.t -> Ir.pattern Context.later
