(** Making two types equal, in the most general way. *)

(** Why it cannot be done: the innermost disagreement, in the order of the arguments. *)
type clash =
  | Different of Type.t * Type.t
  | Different_units of Units.t * Units.t
  | Different_representations of Type.representation * Type.representation
  | Infinite of Type.t  (** a type that would contain itself *)
  | Escaping  (** an outer type would depend on an inner signature's variable *)
  | Out_of_range  (** a unit's exponent, see {!Rational.Out_of_range} *)

val types : Type.t -> Type.t -> (unit, clash) result
(** What was found before a clash stays found: harmless, as a clash ends in a diagnostic.
    {!Type.Erroneous} agrees with everything. *)
