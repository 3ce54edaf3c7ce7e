(** Numbers that look like degrees where an angle is in radians: [cos 90].

    Codes: [W0303]. *)

val is_angle : Type.t -> bool
(** By that name. *)

val operation : Resolve.Ir.expr -> (Resolve.Ir.expr * string * Resolve.Ir.expr) option
(** Two operands with an operator of the prelude between them. *)

val warn : Context.t -> Resolve.Ir.expr -> Expected.t -> unit
(** Of a number without a unit, of more than a whole turn, where an [Angle] is expected by that
    name, or what is added there, or taken away: a literal, or a product or quotient of literals. A
    factor beside a signal says nothing: [sin (100 * t)] is fine. Angles have no dimension, so no
    unit finds this mistake. *)

val compares : string -> bool
(** Is this operator one that compares? *)

val warn_of_operands : Context.t -> Resolve.Ir.expr * Type.t -> Resolve.Ir.expr * Type.t -> unit
(** Of such a number that an angle is compared with: [heading > 90]. For when all types are known.
*)

val keeps : Resolve.Ir.expr -> bool
(** Does this function give an angle of an angle: [abs], a sum? *)

val kept : Type.t -> operand:Type.t -> Type.t
(** The type of its result: by the name of an operand that is an [Angle]. *)
