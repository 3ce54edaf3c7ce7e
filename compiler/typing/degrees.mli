(** Numbers that look like degrees where an angle is in radians: [cos 90].

    Codes: [W0303]. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Of a literal without a unit, of more than a whole turn, where an [Angle] is expected by
    that name. Angles have no dimension, so no unit finds this mistake. *)
