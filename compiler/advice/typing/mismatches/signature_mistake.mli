(** Messages about signatures. Codes: [E0306] more general than the definition · [E0314] a local
    value with type variables · [E0331] an array of unknown size · [E0364], [E0365] a wrong
    constraint · [W0302] variables that look like types. *)

open Basis
open Typing

val construct : Surroundings.construct -> string
(** The construct as part of a sentence. *)

val general_type : Wording.t -> at:Span.t -> Type.rigid -> Type.t -> Diagnostic.t
(** The message about a signature that has a variable where the definition requires this type or
    array size. *)

val general_unit : Wording.t -> at:Span.t -> Units.rigid -> Units.t -> Diagnostic.t

val general_representation :
  Wording.t -> at:Span.t -> Units.rigid -> Type.representation -> Diagnostic.t

val promised_unit : Units.t * Units.t -> (Units.rigid * Units.t) option
(** The variable and the other unit, if one of two clashing units is a single variable of a
    signature and the other contains no such variables. *)

val variable_like_a_type : Wording.t -> at:Span.t -> Ir.variable -> string -> Diagnostic.t
(** The warning [W0302] about a type variable with a name like that of a type, such as [float]. The
    string is the type that was probably meant. *)

(** {1 Other mistakes}

    The functions take the arguments of the facts in {!Typing.Inference_fact.t}. *)

val idle_constraint : at:Span.t -> Ir.variable -> ty:Span.t -> Diagnostic.t
val constraint_on_type : Wording.t -> at:Span.t -> Type.t -> Diagnostic.t
val unknown_size : at:Span.t -> of_:string -> variable:string option -> Diagnostic.t

val polymorphic_value :
  Wording.t -> name:string option -> at:Span.t -> signature:Span.t -> Type.t -> Diagnostic.t
