(** Which type is expected at a place, and why. *)

open Basis

type decider = {
  place : Span.t;
  decides : Type.t;  (** its type *)
  a_size : bool;  (** the variable is the size of an array *)
}
(** An earlier argument whose type has a variable in common with the parameter's. *)

(** Why a type is expected at a place. *)
type reason =
  | Unknown
  | Signature of { name : string; at : Span.t }
  | Annotation of Span.t
  | Parameter of {
      callee : string option;
      head : Resolve.Ir.expr option;  (** what is applied *)
      at : Span.t;
      position : int;
      decided_by : decider list;
      takes : int;  (** how many parameters the callee has *)
      given : Resolve.Ir.expr list;  (** all its arguments *)
      later : Type.t list;  (** of the parameters of the arguments that come after it *)
      before : string option;  (** the operator behind the argument, if it is the last one *)
      of_local : Span.t option;
          (** the callee is a local function without a signature, first applied there *)
    }
  | Operand of { operator : string; other : Resolve.Ir.expr; other_type : Type.t }
      (** beside the other operand *)
  | Branch of Span.t  (** an earlier branch *)
  | Condition
  | Element of Span.t  (** of an array: the first one *)
  | Value of Span.t  (** a pattern's: the value that is matched *)
  | Pattern of Span.t  (** a value's: the pattern that takes it apart *)
  | Statement of Span.t option
      (** of a [do], and what says of its tasks what goes in and comes out *)
  | Last_statement of reason  (** of a [do] that is expected for this reason *)
  | Uses of { name : string; at : Span.t }  (** of what is being defined *)
  | Field of {
      name : string;
      at : Span.t;
      units : string option;  (** what the units of the record's fields have to do with each other *)
    }
  | Output of reason  (** of the signal function that is expected for this reason *)

type t = { ty : Type.t; because : reason }

val make : reason -> Type.t -> t

val explain : Show.words -> t -> Diagnostic.t -> Diagnostic.t
(** Labels the other place: where the expected type comes from. *)

val explain_all : Show.words -> subject:Resolve.Ir.expr option -> t -> Diagnostic.t -> Diagnostic.t
(** Likewise, and if nothing says where it comes from, where the variable is bound that is at fault.
*)
