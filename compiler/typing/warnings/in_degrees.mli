(** Angles that somebody has made degrees of, where angles in radians are: [h * 180 / pi < 90[deg]]
    and [sin (h * 180 / pi)]. Angles have no dimension, so no unit finds this mistake.

    Codes: [W0313]. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Of a product with the factor 180/π, also by the name of an equation, where an [Angle] or an
    [AngularVelocity] is expected by that name. *)

val meets : string -> bool
(** Does this operator compare its operands, or add, or take away? *)

val warn_of_operands : Context.t -> Resolve.Ir.expr * Type.t -> Resolve.Ir.expr * Type.t -> unit
(** Of such a product beside one of these, or a number with the unit [deg], as an operand of what
    {!meets}. For when all types are known. *)
