(** Checks patterns against the type of the matched value. The variables get the types found for
    them, unless a signature has already given them one. *)

val check : Context.t -> Resolve.Ir.pattern -> Expected.t -> Ir.pattern Context.later
