(** Unification: makes two types equal in the most general way. *)

(** The reason why unification failed: the innermost mismatch, in argument order. *)
type clash =
  | Different of Type.t * Type.t
  | Different_units of Units.t * Units.t
  | Different_representations of Type.representation * Type.representation
  | Infinite of Type.t  (** a type that would contain itself *)
  | Escaping  (** the type variable of an inner signature would escape into an outer type *)
  | Out_of_range  (** the exponent of a unit; see {!Rational.Out_of_range} *)

val types : Type.t -> Type.t -> (unit, clash) result
(** Variables solved before a clash remain solved. That is harmless because a clash always leads to
    a diagnostic. {!Type.Erroneous} unifies with everything. *)
