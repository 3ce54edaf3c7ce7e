(** What is said about signatures that promise more than their definitions keep ([E0306]), and about
    variables in them that look like types ([W0302]). *)

open Basis

type owned = { by : string;  (** [the signature of `f`] *) place : Span.t }

type owner = Ir.variable -> owned option
(** Where a variable was named. *)

val general_type : Show.words -> owner -> at:Span.t -> Type.rigid -> Type.t -> Diagnostic.t
(** The signature has a variable where the definition needs this type, or this size of an array. *)

val general_unit : Show.words -> owner -> at:Span.t -> Units.rigid -> Units.t -> Diagnostic.t

val general_representation :
  Show.words -> owner -> at:Span.t -> Units.rigid -> Type.representation -> Diagnostic.t

val promised_unit : Units.t * Units.t -> (Units.rigid * Units.t) option
(** Of two units that clash, the one that is a single variable of a signature, if the other has no
    such variable; and that other one. *)

val variable_like_a_type : Show.words -> at:Span.t -> Ir.variable -> Diagnostic.t option
(** A warning [W0302] about a variable of a signature that is named as a type is, but for its first
    letter. *)
