(** Warns about numbers that look like degrees where an angle in radians is expected: [cos 90].

    Codes: [W0303]. *)

val is_angle : Type.t -> bool
(** Is the type called [Angle]? *)

val operation : Resolve.Ir.expr -> (Resolve.Ir.expr * string * Resolve.Ir.expr) option
(** The operands and the operator, if the expression applies a binary operator of the prelude. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Warns about a number without a unit that is larger than a full turn, if a type written as
    [Angle] is expected, or if the number is added to or subtracted from an angle. The number is a
    literal or a product or quotient of literals. A number that multiplies a signal is not
    suspicious: [sin (100 * t)] is fine. Angles are dimensionless, so the unit checker cannot find
    this mistake. *)

val compares : string -> bool
(** Is this a comparison operator? *)

val warn_of_operands : Context.t -> Resolve.Ir.expr * Type.t -> Resolve.Ir.expr * Type.t -> unit
(** Like {!warn}, for a number that is compared with an angle: [heading > 90]. Call it when all
    types are known. *)

val keeps : Resolve.Ir.expr -> bool
(** Does this function return an angle if its argument is one, as [abs] and addition do? *)

val kept : Type.t -> operand:Type.t -> Type.t
(** The result type of a function for which {!keeps} is true: [Angle] if the operand is an angle. *)
