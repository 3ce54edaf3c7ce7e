(** Numbers that look like degrees where an angle is in radians: [cos 90].

    Codes: [W0303]. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Of a number without a unit, of more than a whole turn, where an [Angle] is expected by
    that name, or what is added there, or taken away: a literal, or a product or quotient of
    literals. A factor beside a signal says nothing: [sin (100 * t)] is fine. Angles have no
    dimension, so no unit finds this mistake. *)
