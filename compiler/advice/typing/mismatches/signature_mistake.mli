(** Messages about signatures that are more general than their definitions ([E0306]), and about
    variables in signatures that look like types ([W0302]). *)

open Basis
open Typing

val construct : Show.construct -> string
(** The construct as part of a sentence. *)

val general_type : Show.words -> at:Span.t -> Type.rigid -> Type.t -> Diagnostic.t
(** The message about a signature that has a variable where the definition requires this type or
    array size. *)

val general_unit : Show.words -> at:Span.t -> Units.rigid -> Units.t -> Diagnostic.t

val general_representation :
  Show.words -> at:Span.t -> Units.rigid -> Type.representation -> Diagnostic.t

val promised_unit : Units.t * Units.t -> (Units.rigid * Units.t) option
(** The variable and the other unit, if one of two clashing units is a single variable of a
    signature and the other unit contains no variables of signatures. *)

val variable_like_a_type : Show.words -> at:Span.t -> Ir.variable -> string -> Diagnostic.t
(** The warning [W0302] about a type variable that differs from the name of a type only in the case
    of a letter. *)
