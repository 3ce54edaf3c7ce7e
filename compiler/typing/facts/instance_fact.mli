(** Facts about types that lack a required class. *)

open Basis

(** Why a use of a name requires a class. *)
type cause =
  | Signature of { name : string; class_ : Ir.class_; parameter : Type.t }
      (** the signature of this name has the constraint *)
  | Superclass of { class_ : Ir.class_; of_ : Ir.Global.t }

(** The construct that requires a class: the use of a name, or the instance of a class for a type.
*)
type user = Name of string | Instance of Ir.class_ * Type.t

type constraint_ = int * Ir.class_
(** The id of a quantified variable, and a class that the variable is required to have. *)

type required = {
  class_ : Ir.class_;
  argument : Type.t;
  at : Span.t;
  by : user;
  because : (Span.t * cause) option;  (** the place that imposes the constraint, and the reason *)
  from : constraint_ option;  (** the constraint in the scheme of the name *)
}
(** A class that a construct in the program requires. *)

type lack = { lacking : Ir.class_; culprit : Type.t; through : Environment.instance list }
(** A constraint that cannot be satisfied, and the instances that led to it, in reverse order. *)

type promise = {
  required : required;  (** the use that needs the class *)
  class_ : Ir.class_;
      (** the class that the variable needs, derived from [required] through instances if necessary
      *)
  variable : Ir.variable;
  of_ : Type.t;  (** the variable as a type *)
}
(** A class that a definition requires of a type variable but that is missing from the context of
    its signature. *)

type t =
  | No_instance of { required : required; lack : lack }
  | Not_a_condition of { at : Span.t; ty : Type.t }  (** the argument of an assertion *)
  | Undecided of { required : required; class_ : Ir.class_ }
      (** nothing determines the type for which the class is required *)
  | Unpromised of { first : promise; others : promise list }
      (** all missing from the context of the same signature; none of them is implied by another *)
