(** Warns about angles converted to degrees where radians are expected: [h * 180 / pi < 90[deg]] and
    [sin (h * 180 / pi)]. Angles are dimensionless, so the unit checker cannot find this mistake.

    Codes: [W0313]. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Warns about a product with the factor 180/π, or a variable defined as such a product, where a
    type written as [Angle] or [AngularVelocity] is expected. *)

val meets : string -> bool
(** Does this operator compare, add or subtract its operands? *)

val warn_of_operands : Context.t -> Resolve.Ir.expr * Type.t -> Resolve.Ir.expr * Type.t -> unit
(** Warns if one operand is a product with the factor 180/π, and the other is an angle, an angular
    velocity or a number with the unit [deg]. {!meets} must be true for the operator. Call it when
    all types are known. *)
